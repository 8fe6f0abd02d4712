// Law: against the same configuration assembled in long double, the derivatives of a configuration
// are as good as its margin says; where its status is ok they have six digits, and so have its
// accelerations.
#include <assur/kinematics.hpp>
#include <assur/mechanism/group_model.hpp>
#include <assur/support/second_rates.hpp>
#include <iostream>

#include "kind_in_space.hpp"
#include "largest.hpp"
#include "runtime/exact.hpp"
#include "runtime/model_types.hpp"
#include "runtime/near_singular_groups.hpp"
#include "solve/precision.hpp"
#include "whole_campaign.hpp"

namespace assur::test::regularity_test {
namespace {

using Long = long double;

constexpr unsigned seed = 8128;
constexpr int samples = 300;

using LongRows = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;

/// Largest difference over the largest entry, among the unknowns of one unit.
double relative_error(const std::vector<ModelUnknown>& unknowns,
                      const mechanism::models::SmallMatrix& found, const LongRows& truth) {
  double worst = 0;
  for (const bool angles : {false, true}) {
    Long difference = 0;
    Long size = 0;
    for (Eigen::Index row = 0; row < found.rows(); ++row) {
      if (unknowns[static_cast<std::size_t>(row)].is_angle == angles) {
        for (Eigen::Index column = 0; column < found.cols(); ++column) {
          difference = largest(difference, std::abs(found(row, column) - truth(row, column)));
          size = std::max(size, std::abs(truth(row, column)));
        }
      }
    }
    if (size > 0) {
      worst = largest(worst, static_cast<double>(difference / size));
    }
  }
  return worst;
}

/// What was promised and what is true.
struct Promises {
  int compared = 0;
  int regular = 0;
  int regular_at_second_look = 0;
  double worst_margin = 0;       ///< error in units of eps / margin
  double worst_regular = 0;      ///< error where `regularity` says ok
  double worst_second_look = 0;  ///< where the second look says ok
  /// The worst errors of accelerations where the second look says ok, and where the pivots do.
  double worst_acceleration = 0, worst_acceleration_by_pivots = 0;
  int regular_in_motion = 0, regular_in_motion_by_pivots = 0;

  void expect(const char* which, int least) const {
    std::cout << "seed " << seed << ", " << which << ": " << compared << " configurations, at most "
              << worst_margin << " eps/margin; " << regular << " regular, at most " << worst_regular
              << "; at a second look " << regular_at_second_look << ", at most "
              << worst_second_look << "; in motion " << regular_in_motion << " regular, "
              << regular_in_motion_by_pivots << " by the pivots, accelerations at most "
              << worst_acceleration << " and " << worst_acceleration_by_pivots << "\n";
    EXPECT_GT(compared, least);
    EXPECT_LE(worst_regular, 5e-7);
    EXPECT_LE(worst_second_look, 5e-7);
    EXPECT_LE(worst_acceleration, 5e-7);
    EXPECT_LE(worst_acceleration_by_pivots, 5e-7);
    EXPECT_GT(regular_in_motion_by_pivots, least / 4);
    EXPECT_GE(regular_in_motion, regular_in_motion_by_pivots);
    EXPECT_GE(regular_at_second_look, regular);
  }
};

/// A configuration of a group and its derivatives, as mechanisms see them.
struct Standing {
  Standing(const mechanism::GroupModel& row, const mechanism::models::FlatVariables& d,
           const mechanism::models::FlatVariables& u, const mechanism::models::FlatVariables& q,
           const Eigen::VectorXd& input_rate, const Eigen::VectorXd& input_second_rate)
      : model(row) {
    mechanism::models::MotionQuery query;
    query.derivatives = true;
    query.input_rate = input_rate;
    query.input_second_rate = input_second_rate;
    row.kernel->move(d, u, q, query, motion);
    regularity = mechanism::solve::precision_of(row, d, u, q, query, motion).regularity;
  }
  const mechanism::GroupModel& model;
  mechanism::models::GroupMotion motion;
  Status regularity;
};

/// Counts what `found` promises, and how far it is from the truth.
void compare(const Standing& found, const LongRows& to_dimensions, const LongRows& to_inputs,
             Promises& kept) {
  ++kept.compared;
  const auto& unknowns = found.model.unknowns;
  const double error = largest(relative_error(unknowns, found.motion.q_d, to_dimensions),
                               relative_error(unknowns, found.motion.q_u, to_inputs));
  const Regularity<double>& standing = found.motion.standing;
  kept.worst_margin =
      largest(kept.worst_margin, error * standing.margin / std::numeric_limits<double>::epsilon());
  if (standing.status == Status::ok) {
    ++kept.regular;
    kept.worst_regular = largest(kept.worst_regular, error);
  }
  if (found.regularity == Status::ok) {
    ++kept.regular_at_second_look;
    kept.worst_second_look = largest(kept.worst_second_look, error);
  }
}

/// The row of a generated model.
template <typename Model>
const mechanism::GroupModel& row_of() {
  const auto& groups = mechanism::known_groups();
  const auto group = std::find_if(groups.begin(), groups.end(), [](const auto& candidate) {
    return candidate.structure.name == Model::group;
  });
  return group->models[static_cast<std::size_t>(Model::number - 1)];
}

template <typename Model>
class Regular : public testing::Test {
 protected:
  using Groups = NearSingularGroups<Model>;
  template <typename Scalar>
  using Group = typename Groups::template Group<Scalar>;

  /// The sensitivities of a group in double against those in long double.
  void compare(Group<double> group, Promises& kept) {
    if (!is_solvable(refine<Model, double>(group.d, group.u, group.q))) {
      return;
    }
    const auto d = Groups::template in_scalar<typename Model::template Dimensions<Long>>(group.d);
    const auto u = Groups::template in_scalar<typename Model::template Inputs<Long>>(group.u);
    auto q = Groups::template in_scalar<typename Model::template Configuration<Long>>(group.q);
    if (refine<Model, Long>(d, u, q) != Status::ok) {
      return;
    }
    // The configuration in double, refined from the true one.
    group.q = Groups::template in_scalar<typename Model::template Configuration<double>>(q);
    if (!is_solvable(refine<Model, double>(group.d, group.u, group.q))) {
      return;
    }
    Sensitivities<Model, Long> truth;
    const auto flat = [](const auto& variables) {
      mechanism::models::FlatVariables result{};
      support::flatten(variables, result);
      return result;
    };
    const Rates still = Rates::Zero();
    const Standing found(row_of<Model>(), flat(group.d), flat(group.u), flat(group.q), still,
                         still);
    if (is_solvable(found.motion.standing.status) &&
        sensitivities<Model, Long>(d, u, q, truth) == Status::ok) {
      regularity_test::compare(found, truth.to_dimensions, truth.to_inputs, kept);
      for (const auto& [rate, second_rate] : {random_rates(), crossing_rates(d, u, q)}) {
        Motion<Model, Long> moving;
        if (motion<Model, Long>(d, u, q, rate.template cast<Long>(),
                                second_rate.template cast<Long>(), moving) == Status::ok) {
          compare_motion(
              {row_of<Model>(), flat(group.d), flat(group.u), flat(group.q), rate, second_rate},
              moving, kept);
        }
      }
    }
  }

 private:
  using Rates = Vector<double, Model::input_count>;
  using LongUnknowns = Vector<Long, Model::unknown_count>;

  std::pair<Rates, Rates> random_rates() {
    std::uniform_real_distribution<double> any(-1, 1);
    const auto drawn = [&] { return Rates(Rates::NullaryExpr([&] { return any(engine_); })); };
    const Rates rate = drawn();
    return {rate, drawn()};
  }
  /// Rates of the inputs that give the unknowns rates of moderate size, as they have where
  /// configurations cross.
  template <typename Dimensions, typename Inputs, typename Configuration>
  std::pair<Rates, Rates> crossing_rates(const Dimensions& d, const Inputs& u,
                                         const Configuration& q) {
    std::uniform_real_distribution<double> any(-1, 1);
    const auto wanted = [&] {
      return LongUnknowns(LongUnknowns::NullaryExpr([&] { return Long(any(engine_)); }));
    };
    Matrix<Long, Model::equation_count, Model::unknown_count> J;
    Matrix<Long, Model::equation_count, Model::input_count> f_u;
    Model::jacobian(d, u, q, J);
    Model::input_jacobian(d, u, q, f_u);
    const auto inputs_for = [&](const LongUnknowns& rates) {
      const Vector<Long, Model::equation_count> closures = -J * rates;
      return Rates(least_change(f_u.template cast<double>(), closures.template cast<double>()));
    };
    const Rates rate = inputs_for(wanted());
    Motion<Model, Long> moving;
    if (motion<Model, Long>(d, u, q, rate.template cast<Long>(),
                            Vector<Long, Model::input_count>::Zero(), moving) != Status::ok) {
      return {rate, Rates::Zero()};
    }
    // Much larger accelerations of the inputs would add rounding of their own.
    const Rates second_rate = inputs_for(wanted() - moving.acceleration);
    return {rate, second_rate.cwiseAbs().maxCoeff() < 100 ? second_rate : Rates(Rates::Zero())};
  }

  static void compare_motion(const Standing& found, const Motion<Model, Long>& truth,
                             Promises& kept) {
    const double size = found.motion.size;
    const auto largest_of = [size](const auto& of) {
      double result = 0;
      for (int row = 0; row < Model::unknown_count; ++row) {
        const bool is_angle = Model::unknowns[static_cast<std::size_t>(row)].is_angle;
        const double unit = is_angle ? size : 1;
        result = largest(result, unit * static_cast<double>(std::abs(of(row))));
      }
      return result;
    };
    const double rate = largest_of(truth.velocity);
    const Vector<double, Model::unknown_count> q_rate = found.motion.rate;
    const Vector<double, Model::unknown_count> q_second_rate = found.motion.second_rate;
    const double error =
        largest_of(LongUnknowns(q_second_rate.template cast<Long>() - truth.acceleration)) /
        std::max(largest_of(truth.acceleration), rate * rate / size);
    if (found.regularity == Status::ok) {
      ++kept.regular_in_motion;
      kept.worst_acceleration = largest(kept.worst_acceleration, error);
    }
    const double by_pivots =
        support::second_rate_error<Model>(found.motion.standing, q_rate, q_second_rate, size);
    if (by_pivots < support::six_digits) {
      ++kept.regular_in_motion_by_pivots;
      kept.worst_acceleration_by_pivots = largest(kept.worst_acceleration_by_pivots, error);
    }
  }

 protected:
  Groups groups_{seed + static_cast<unsigned>(Model::number)};

 private:
  std::mt19937 engine_{seed};
};

TYPED_TEST_SUITE(Regular, AllModels, ModelNames);

TYPED_TEST(Regular, SensitivitiesAreAsGoodAsTheMarginSays) {
  using Model = TypeParam;
  if constexpr (Model::rigid) {
    Promises kept;
    for (const double shrink : {1.0, 1e-2, 1e-4, 1e-6, 1e-8}) {
      for (int sample = 0; sample < samples; ++sample) {
        this->compare(this->groups_.drawn(shrink), kept);
      }
    }
    kept.expect("random", samples / 10);
    EXPECT_LE(kept.worst_margin, derivative_error_constant);
  }
}

/// Between two configurations with determinants of opposite signs there is a singular one; beside
/// it, at known distances, the estimates are close to what they estimate.
TYPED_TEST(Regular, SixDigitsHoldBesideASingularConfigurationToo) {
  using Model = TypeParam;
  if constexpr (Model::rigid) {
    Promises kept;
    for (int sample = 0; sample < samples; ++sample) {
      const auto from = this->groups_.drawn(1);
      const auto to = this->groups_.drawn(1);
      const double singular = this->groups_.singular_between(from, to);
      for (const double distance : {1e-1, 1e-2, 1e-3, 3e-4, 1e-4}) {
        this->compare(this->groups_.between(from, to, singular + distance), kept);
      }
    }
    kept.expect("beside singular ones", samples);
  }
}

/// The error of the arithmetic alone, at configurations with an ample margin that are taken as
/// exact in double. One draw in thousands has such a margin, so each of these has neighbours, too.
TEST(Accuracy, OfWellShapedTetradsIsThatOfAFewRoundings) {
  using Model = tetrad::Model01;
  const int wanted = is_whole_campaign() ? 2000 : 400;
  constexpr int neighbours = 19;
  RandomInputs random(seed);
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> nearby(0.9, 1.1);
  const auto scaled = [&](const auto& source) {
    auto target = source;
    if constexpr (!requires { source.cos; }) {
      target *= nearby(engine);
    }
    return target;
  };
  const auto to_long = [](const auto& source) {
    if constexpr (requires { source.cos; }) {
      return Direction<Long>{source.cos, source.sin};
    } else {
      return static_cast<Long>(source);
    }
  };
  const auto to_double = [](const auto& source) {
    if constexpr (requires { source.cos; }) {
      return Direction<double>{static_cast<double>(source.cos), static_cast<double>(source.sin)};
    } else {
      return static_cast<double>(source);
    }
  };
  const auto error = [](const auto& found, const auto& truth) {
    return static_cast<double>((found.template cast<Long>() - truth).cwiseAbs().maxCoeff() /
                               truth.cwiseAbs().maxCoeff());
  };
  double of_sensitivities = 0;
  double of_accelerations = 0;
  struct {
    Model::Dimensions<double> d;
    Model::Inputs<double> u;
    Model::Configuration<double> q;
  } drawn;
  unsigned draw = seed;
  int left = 0;
  for (int compared = 0; compared < wanted;) {
    const bool fresh = left == 0;
    if (fresh) {
      const KindInSpace<Model> space(Model::kinds[0], draw++);
      std::array<NormalForm<Real>, Model::link_count> forms;
      ASSERT_EQ(space.normal_forms(forms), Status::ok);
      Model::Dimensions<Real> exact;
      ASSERT_EQ((fill_dimensions<Model, Real>(forms, exact)), Status::ok);
      drawn = {converted<Model::Dimensions<double>>(exact, to_double),
               converted<Model::Inputs<double>>(space.inputs(), to_double),
               converted<Model::Configuration<double>>(space.configuration(forms), to_double)};
    } else {
      --left;
    }
    const auto d = fresh ? drawn.d : converted<Model::Dimensions<double>>(drawn.d, scaled);
    const auto u = fresh ? drawn.u : converted<Model::Inputs<double>>(drawn.u, scaled);
    auto q = drawn.q;
    const auto u1 = random.vector<Vector<double, Model::input_count>>();
    const auto u2 = random.vector<Vector<double, Model::input_count>>();
    if (refine<Model, double>(d, u, q) != Status::ok ||
        regularity<Model, double>(d, u, q).margin < 1e-2) {
      continue;
    }
    left = fresh ? neighbours : left;
    ++compared;
    Sensitivities<Model, double> sensitive;
    Motion<Model, double> moving;
    ASSERT_EQ((sensitivities_and_motion<Model, double>(d, u, q, u1, u2, sensitive, moving)),
              Status::ok);
    Sensitivities<Model, Long> true_sensitive;
    Motion<Model, Long> true_moving;
    ASSERT_EQ((sensitivities_and_motion<Model, Long>(
                  converted<Model::Dimensions<Long>>(d, to_long),
                  converted<Model::Inputs<Long>>(u, to_long),
                  converted<Model::Configuration<Long>>(q, to_long), u1.cast<Long>(),
                  u2.cast<Long>(), true_sensitive, true_moving)),
              Status::ok);
    of_sensitivities = largest(
        of_sensitivities, std::max(error(sensitive.to_dimensions, true_sensitive.to_dimensions),
                                   error(sensitive.to_inputs, true_sensitive.to_inputs)));
    of_accelerations =
        largest(of_accelerations, error(moving.acceleration, true_moving.acceleration));
  }
  std::cout << "seed " << seed << ", " << wanted << " RRR-RRR tetrads: relative error of the "
            << "sensitivities " << of_sensitivities << ", of the accelerations " << of_accelerations
            << "\n";
  EXPECT_LE(of_sensitivities, 2e-15);
  EXPECT_LE(of_accelerations, 1e-14);
}

}  // namespace
}  // namespace assur::test::regularity_test
