// Law: the answer for a group in float is that in double for the same numbers, or unresolved.
#include <assur/assembly.hpp>
#include <assur/kinematics.hpp>
#include <cmath>
#include <iostream>
#include <limits>
#include <type_traits>
#include <vector>

#include "largest.hpp"
#include "runtime/compiled_models.hpp"
#include "runtime/drawn_groups.hpp"
#include "runtime/model_types.hpp"
#include "whole_campaign.hpp"

namespace assur::test::float_groups_test {
namespace {

constexpr unsigned seed = 1702;
/// `ctest -L long` draws all samples.
const int samples = is_whole_campaign() ? 10000 : 100;

/// What was seen of one model.
struct Seen {
  int groups = 0, configurations = 0, regular = 0;
  int unresolved = 0, undecided = 0, miscounted = 0;
  int reordered = 0;  ///< pairs that come in another order than in double
  double apart = 0;   ///< how far the keys of such a pair are apart at least, the largest of these
  double pose = 0;    ///< by how many eps closures must be off to explain configurations
  double derivative = 0;  ///< largest error of derivatives where they are regular
  double promised = 0;    ///< largest error of derivatives relative to the promised one
  double constant = 0;    ///< largest error of all derivatives, in eps/margin
};

/// The longest length of a group, or one where all vanish.
template <typename Model>
double size_of(const typename Model::template Dimensions<double>& d,
               const typename Model::template Inputs<double>& u) {
  const double longest = support::own_size<Model, double>(d, u);
  return longest > 0 ? longest : 1;
}

/// The error of a configuration: of directions, and of displacements relative to the longest length
/// of the group, or to the longest displacement where that is longer and so is rounded more.
template <typename Model>
double distance(const typename Model::template Configuration<float>& q,
                const typename Model::template Configuration<double>& truth, double longest) {
  const double unit = std::max(longest, longest_length(truth));
  double farthest = 0;
  for_each_pair(q, truth, [&](const auto& one, const auto& other) {
    if constexpr (detail::is_direction<std::decay_t<decltype(one)>>) {
      farthest = largest(farthest, std::abs(static_cast<double>(one.cos) - other.cos));
      farthest = largest(farthest, std::abs(static_cast<double>(one.sin) - other.sin));
    } else {
      farthest = largest(farthest, std::abs(static_cast<double>(one) - other) / unit);
    }
  });
  return farthest;
}

/// The closure residual, relative to the longest length or displacement, that explains the error of
/// an unknown: dq = J^-1 df.
template <typename Model>
double needed_of_closures(
    const typename Model::template Configuration<float>& q,
    const typename Model::template Configuration<double>& truth,
    const Matrix<double, Model::unknown_count, Model::equation_count>& inverse, double longest) {
  const double unit = std::max(longest, longest_length(truth));
  double needed = 0;
  std::size_t row = 0;
  for_each_pair(q, truth, [&](const auto& one, const auto& other) {
    double off = 0;
    if constexpr (detail::is_direction<std::decay_t<decltype(one)>>) {
      off = std::hypot(static_cast<double>(one.cos) - other.cos,
                       static_cast<double>(one.sin) - other.sin);
    } else {
      off = std::abs(static_cast<double>(one) - other);
    }
    const double loose = inverse.row(static_cast<Eigen::Index>(row++)).cwiseAbs().sum();
    needed = largest(needed, off / (loose * unit));
  });
  return needed;
}

/// Factors that make derivatives by lengths comparable with those by angles.
template <typename Variables>
Eigen::VectorXd units_of(const Variables& variables, double longest) {
  std::vector<double> units;
  for_each_member(variables, [&](const auto& member, std::size_t) {
    units.push_back(detail::is_direction<std::decay_t<decltype(member)>> ? 1 : longest);
  });
  return Eigen::Map<const Eigen::VectorXd>(units.data(), static_cast<Eigen::Index>(units.size()));
}

/// The largest difference of derivatives by dimensions and inputs over the largest derivative,
/// among unknowns of one unit. The latter does not vanish: if the base turns, so do the links, and
/// a larger group has longer displacements. Derivatives by a single parameter may vanish.
template <typename Model>
double difference(const typename Model::template Dimensions<double>& d,
                  const typename Model::template Inputs<double>& u, double longest,
                  const Sensitivities<Model, float>& found,
                  const Sensitivities<Model, double>& truth) {
  double worst = 0;
  for (const bool angles : {false, true}) {
    double off = 0;
    double size = 0;
    const auto look = [&](const auto& rows, const auto& true_rows, const Eigen::VectorXd& units) {
      for (Eigen::Index row = 0; row < rows.rows(); ++row) {
        if (Model::unknowns[static_cast<std::size_t>(row)].is_angle == angles) {
          for (Eigen::Index column = 0; column < rows.cols(); ++column) {
            const double exact = true_rows(row, column);
            const double away = std::abs(static_cast<double>(rows(row, column)) - exact);
            off = largest(off, away * units(column));
            size = std::max(size, std::abs(exact) * units(column));
          }
        }
      }
    };
    look(found.to_dimensions, truth.to_dimensions, units_of(d, longest));
    look(found.to_inputs, truth.to_inputs, units_of(u, longest));
    worst = size > 0 ? largest(worst, off / size) : worst;
  }
  return worst;
}

/// The least difference of the sort keys of two configurations, except keys equal to within the
/// rounding of double. It is relative to the key or its unit, which is one or, for lengths, `unit`.
template <typename Model>
double least_difference_of_keys(const typename Model::template Dimensions<double>& d,
                                const typename Model::template Inputs<double>& u,
                                const typename Model::template Configuration<double>& one,
                                const typename Model::template Configuration<double>& other,
                                double unit) {
  using Pair = numeric::PairOf<double>;
  double least = std::numeric_limits<double>::infinity();
  detail::for_each_key<Model, Pair>(
      support::scaled_to<typename Model::template Dimensions<Pair>>(d, 1),
      support::scaled_to<typename Model::template Inputs<Pair>>(u, 1),
      detail::pair_of<Model, double>(one, other), [&](const Pair& key, int, bool is_length) {
        const double size = std::max(is_length ? unit : 1, std::abs(key[0]));
        const double difference = std::abs(key[0] - key[1]) / size;
        least = difference > 1e-13 ? std::min(least, difference) : least;
      });
  return least;
}

template <typename Model>
class Comparison {
  template <typename Scalar>
  using Dimensions = typename Model::template Dimensions<Scalar>;
  template <typename Scalar>
  using Inputs = typename Model::template Inputs<Scalar>;
  template <typename Scalar>
  using Configuration = typename Model::template Configuration<Scalar>;
  static constexpr double epsilon = std::numeric_limits<float>::epsilon();

 public:
  void look_at(const Dimensions<float>& d, const Inputs<float>& u) {
    ++seen_.groups;
    const auto found = assemblies<Model, float, Unresolved::refuse>(d, u);
    if (found.status == AssemblyStatus::unresolved) {
      ++seen_.unresolved;
      return;
    }
    const auto exact_d = detail::widened<Dimensions<double>>(d);
    const auto exact_u = detail::widened<Inputs<double>>(u);
    const auto truth = compiled::assemblies<Model>(exact_d, exact_u);
    if (found.status != truth.status || found.count != truth.count || truth.mobility > 0) {
      ++seen_.miscounted;
      return;
    }
    const double longest = size_of<Model>(exact_d, exact_u);
    std::array<bool, Assemblies<Model>::capacity> taken{};
    std::array<std::size_t, Assemblies<Model>::capacity> numbers{};
    for (std::size_t index = 0; index < static_cast<std::size_t>(found.count); ++index) {
      const auto& q = found.configurations[index];
      std::size_t nearest = taken.size();
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t other = 0; other < static_cast<std::size_t>(truth.count); ++other) {
        const double away = distance<Model>(q, truth.configurations[other], longest);
        if (!taken[other] && away < least) {
          least = away;
          nearest = other;
        }
      }
      if (nearest == taken.size()) {
        ++seen_.miscounted;
        return;
      }
      taken[nearest] = true;
      numbers[index] = nearest;
      for (std::size_t before = 0; before < index; ++before) {
        if (numbers[before] > nearest) {
          ++seen_.reordered;
          seen_.apart =
              largest(seen_.apart, least_difference_of_keys<Model>(
                                       exact_d, exact_u, truth.configurations[numbers[before]],
                                       truth.configurations[nearest], longest));
        }
      }
      compare(d, u, q, exact_d, exact_u, truth.configurations[nearest], longest,
              found.regularity[index] == Status::ok);
    }
  }

  [[nodiscard]] const Seen& seen() const { return seen_; }

 private:
  void compare(const Dimensions<float>& d, const Inputs<float>& u, const Configuration<float>& q,
               const Dimensions<double>& exact_d, const Inputs<double>& exact_u,
               const Configuration<double>& exact_q, double longest, bool is_regular) {
    ++seen_.configurations;
    Sensitivities<Model, float> sensitive;
    Sensitivities<Model, double> truth;
    const auto standing = regularity<Model, float>(d, u, q);
    Matrix<double, Model::unknown_count, Model::equation_count> inverse;
    Model::inverse_jacobian(exact_d, exact_u, exact_q, inverse);
    const double needed = needed_of_closures<Model>(q, exact_q, inverse, longest);
    seen_.pose = largest(seen_.pose, needed / epsilon);
    Model::sensitivities(d, u, q, sensitive.to_dimensions, sensitive.to_inputs);
    if (!is_solvable(sensitivities<Model, double>(exact_d, exact_u, exact_q, truth))) {
      return;
    }
    const double error = difference<Model>(exact_d, exact_u, longest, sensitive, truth);
    seen_.promised = largest(seen_.promised, error / static_cast<double>(standing.error()));
    seen_.constant =
        largest(seen_.constant, error * static_cast<double>(standing.margin) / epsilon);
    if (is_regular) {
      ++seen_.regular;
      seen_.derivative = largest(seen_.derivative, error);
    }
  }

  Seen seen_;
};

template <typename Model>
class FloatGroups : public testing::Test {};
TYPED_TEST_SUITE(FloatGroups, AllModels, ModelNames);

template <typename Model>
void compare_with_double(bool on_lattice) {
  if constexpr (Model::rigid) {
    DrawnGroups<float> draws(seed + static_cast<unsigned>(Model::number), on_lattice);
    Comparison<Model> comparison;
    for (int sample = 0; sample < samples; ++sample) {
      const auto d = draws.template variables<typename Model::template Dimensions<float>>();
      const auto u = draws.template variables<typename Model::template Inputs<float>>();
      comparison.look_at(d, u);
    }
    const Seen& seen = comparison.seen();
    std::cout << model_name<Model>() << (on_lattice ? " lattice" : " general") << ": groups "
              << seen.groups << ", unresolved " << seen.unresolved << ", configurations "
              << seen.configurations << ", regular " << seen.regular << ", poses " << seen.pose
              << " eps, reordered " << seen.reordered << " by " << seen.apart << ", derivatives "
              << seen.derivative << ", of promised " << seen.promised << ", " << seen.constant
              << " eps/margin\n";
    EXPECT_EQ(seen.miscounted, 0);
    // A search that decides nothing would say nothing wrong.
    if (!on_lattice) {
      EXPECT_LE(4 * seen.unresolved, seen.groups);
    }
    EXPECT_LT(seen.derivative, 5e-4);
    EXPECT_LT(seen.promised, 1);
    EXPECT_LT(seen.apart, 2e-3);  // as docs/method/positions.md says
    EXPECT_LT(seen.constant, derivative_error_constant);
    EXPECT_LT(seen.pose, detail::polished_rounding(1.0F) / std::numeric_limits<float>::epsilon());
  }
}

TYPED_TEST(FloatGroups, SayWhatDoubleSaysInGeneralPosition) {
  compare_with_double<TypeParam>(false);
}

TYPED_TEST(FloatGroups, SayWhatDoubleSaysOnALattice) { compare_with_double<TypeParam>(true); }

/// A crank-rocker of 4, 1, 3 and 3.5 is far from its limits all the way round.
TEST(FloatGroups, CallAHealthyFourBarRegularAtEveryCrankAngle) {
  using Model = dyad::Model01;
  const Model::Dimensions<float> d{3, 3.5F};
  for (int angle = 0; angle < 360; angle += 5) {
    const auto crank = direction_of(static_cast<float>(angle) * 0.017453292F);
    const Model::Inputs<float> u{crank.cos, crank.sin, 4, 0};
    const auto found = assemblies<Model, float, Unresolved::refuse>(d, u);
    ASSERT_EQ(found.status, AssemblyStatus::ok) << angle;
    ASSERT_EQ(found.count, 2) << angle;
    EXPECT_EQ(found.regularity[0], Status::ok) << angle;
    EXPECT_EQ(found.regularity[1], Status::ok) << angle;
  }
}

}  // namespace
}  // namespace assur::test::float_groups_test
