// Law: the sensitivities of an assembled configuration are as good as its margin says, against the
// same configuration assembled in long double; six digits hold where the status is ok.
#include <assur/kinematics.hpp>
#include <assur/mechanism/group_model.hpp>
#include <iostream>

#include "kind_in_space.hpp"
#include "largest.hpp"
#include "runtime/exact.hpp"
#include "runtime/model_types.hpp"
#include "runtime/near_singular_groups.hpp"
#include "solve/precision.hpp"

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

  void expect(const char* which, int least) const {
    std::cout << "seed " << seed << ", " << which << ": " << compared << " configurations, at most "
              << worst_margin << " eps/margin; " << regular << " regular, at most " << worst_regular
              << "; at a second look " << regular_at_second_look << ", at most "
              << worst_second_look << "\n";
    EXPECT_GT(compared, least);
    EXPECT_LE(worst_regular, 5e-7);
    EXPECT_LE(worst_second_look, 5e-7);
    EXPECT_GE(regular_at_second_look, regular);
  }
};

/// A configuration of a group and its derivatives, as mechanisms see them.
struct Standing {
  Standing(const mechanism::GroupModel& row, const mechanism::models::FlatVariables& d,
           const mechanism::models::FlatVariables& u, const mechanism::models::FlatVariables& q)
      : model(row) {
    mechanism::models::MotionQuery query;
    query.derivatives = true;
    query.input_rate.setZero(static_cast<Eigen::Index>(row.input_count));
    query.input_second_rate = query.input_rate;
    row.kernel->move(d, u, q, query, motion);
    regularity = mechanism::solve::precision_of(row, d, u, q, motion).regularity;
  }
  const mechanism::GroupModel& model;
  mechanism::models::GroupMotion motion;
  Status regularity;
};

/// Counts what `found` promises, beside the truth.
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
    // What double makes of the configuration, from the truth.
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
    const Standing found(row_of<Model>(), flat(group.d), flat(group.u), flat(group.q));
    if (is_solvable(found.motion.standing.status) &&
        sensitivities<Model, Long>(d, u, q, truth) == Status::ok) {
      regularity_test::compare(found, truth.to_dimensions, truth.to_inputs, kept);
    }
  }

  Groups groups_{seed + static_cast<unsigned>(Model::number)};
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

/// On configurations of ample margin, of which double's own digits are the truth: the error of the
/// arithmetic alone. One draw in thousands has such a margin, so each is tried with neighbours.
TEST(Accuracy, OfWellShapedTetradsIsThatOfAFewRoundings) {
  using Model = tetrad::Model01;
  constexpr int wanted = 2000;
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
