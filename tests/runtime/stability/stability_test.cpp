// Laws of the stability laboratory: the results in docs/reports/stability.svg, asserted on the same
// families and the same methods.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <vector>

#include "largest.hpp"
#include "runtime/family_types.hpp"
#include "stability/bad_input.hpp"
#include "stability/measure.hpp"

namespace assur::stability {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// The constant of the error bound C eps kappa.
constexpr double allowed_roundings = 16;
/// The same for an acceleration, which inherits the velocity's error and may be a small difference.
constexpr double allowed_in_acceleration = 256;

/// A member of a family, at its distance from the failure.
template <typename Family>
struct PlacedMember {
  double distance;
  int number;
  Member<typename Family::Model> member;
};

/// Every member at every distance, computed once: their derivatives have 50 digits.
template <typename Family>
const std::vector<PlacedMember<Family>>& members_of() {
  static const std::vector<PlacedMember<Family>> members = [] {
    std::vector<PlacedMember<Family>> list;
    for (const double distance : distances<Family>()) {
      for (int number = 0; number < members_per_distance; ++number) {
        list.push_back({distance, number, make_member<Family>(number, distance)});
      }
    }
    return list;
  }();
  return members;
}

template <typename Family>
class Stability : public testing::Test {
 protected:
  /// Calls with every distance and every member.
  template <typename Check>
  static void on_each(Check check) {
    for (const auto& [distance, number, member] : members_of<Family>()) {
      SCOPED_TRACE(testing::Message() << "distance " << distance << ", member " << number);
      check(distance, member);
    }
  }
};
TYPED_TEST_SUITE(Stability, TypesOf<Families>::Types, FamilyNames);

TYPED_TEST(Stability, GeneratedStaysWithinItsConditionTimesRounding) {
  using Model = typename TypeParam::Model;
  double worst = 0;
  double worst_acceleration = 0;
  int refused = 0;
  this->on_each([&](double, const Member<Model>& member) {
    const Answer<Model> answer = generated<Model>(member.given);
    if (!is_solvable(answer.status)) {
      ++refused;
      EXPECT_EQ(answer.status, Status::singular);
      EXPECT_GT(epsilon * member.truth_as_given.condition, 0.1) << "refused without need";
      return;
    }
    for (const Truth<Model>* truth : {&member.truth, &member.truth_as_given}) {
      const double unit = epsilon * truth->condition;
      if (unit < 1 / allowed_roundings) {  // else the bound exceeds the result itself
        for (const Quantity quantity : {Quantity::sensitivities, Quantity::velocity}) {
          const double roundings = error_of(answer, *truth, quantity) / unit;
          EXPECT_LE(roundings, allowed_roundings)
              << quantity_names[static_cast<std::size_t>(quantity)];
          worst = test::largest(worst, roundings);
        }
        const double bent = error_of(answer, *truth, Quantity::acceleration) / unit;
        EXPECT_LE(bent, allowed_in_acceleration) << "acceleration";
        worst_acceleration = test::largest(worst_acceleration, bent);
      }
    }
  });
  std::cout << TypeParam::name << ", seed " << seed << ": largest error " << worst
            << " eps kappa, of an acceleration " << worst_acceleration << ", refused " << refused
            << '\n';
}

/// An acceleration inherits the error of the velocity from which it is computed. What it adds is
/// kappa times the rounding of its right-hand side, whose terms may cancel.
TYPED_TEST(Stability, AccelerationAddsItsConditionTimesRounding) {
  using Model = typename TypeParam::Model;
  double worst = 0;
  int checked = 0;
  this->on_each([&](double, const Member<Model>& member) {
    const Answer<Model> answer = generated<Model>(member.given);
    if (!is_solvable(answer.status)) {
      return;
    }
    const Vector<Real, Model::unknown_count> velocity =
        answer.motion.velocity.template cast<Real>();
    const AccelerationOf<Model> truth = acceleration_of(converted<Real>(member.given), velocity);
    const double unit = epsilon * member.truth_as_given.condition * truth.cancellation;
    if (unit < 1 / allowed_roundings) {
      ++checked;
      const double roundings = relative_error(answer.motion.acceleration, truth.acceleration,
                                              member.truth_as_given.weights) /
                               unit;
      EXPECT_LE(roundings, allowed_roundings);
      worst = test::largest(worst, roundings);
    }
  });
  std::cout << TypeParam::name << ", seed " << seed << ": acceleration adds " << worst
            << " eps kappa of its terms, members checked " << checked << '\n';
}

/// If the configuration is given, every stable way to solve the same equations has the same bound.
TYPED_TEST(Stability, PivotingAndAutomaticDifferentiationAreBoundedAlike) {
  using Model = typename TypeParam::Model;
  this->on_each([&](double, const Member<Model>& member) {
    const double unit = epsilon * member.truth_as_given.condition;
    if (unit < 1 / allowed_roundings) {
      for (const auto method :
           {partial_pivot_lu<Model>, full_pivot_lu<Model>, automatic_differentiation<Model>}) {
        const Answer<Model> answer = method(member.given);
        ASSERT_TRUE(is_solvable(answer.status));
        for (const Quantity quantity : {Quantity::sensitivities, Quantity::velocity}) {
          EXPECT_LE(error_of(answer, member.truth_as_given, quantity), allowed_roundings * unit);
        }
      }
    }
  });
}

/// Errors are within what the runtime's own margin promises. Accelerations, which inherit the error
/// of the velocity, are printed alone.
TYPED_TEST(Stability, GeneratedStaysWithinItsMargin) {
  using Model = typename TypeParam::Model;
  std::array<double, 3> worst{};
  this->on_each([&](double, const Member<Model>& member) {
    const Answer<Model> answer = generated<Model>(member.given);
    if (is_solvable(answer.status)) {
      const double margin =
          regularity<Model, double>(member.given.d, member.given.u, member.given.q).margin;
      for (const Quantity quantity : quantities) {
        double& so_far = worst[static_cast<std::size_t>(quantity)];
        const double error = error_of(answer, member.truth, quantity);
        so_far = test::largest(so_far, error * margin / epsilon);
      }
    }
  });
  std::cout << TypeParam::name << ": largest error in eps/margin, sensitivities " << worst[0]
            << ", velocity " << worst[1] << ", acceleration " << worst[2] << '\n';
  EXPECT_LT(worst[0], derivative_error_constant);
  EXPECT_LT(worst[1], derivative_error_constant);
}

/// `ok` promises six digits of what J alone decides. An acceleration also inherits the error of the
/// velocity; its errors are printed.
TYPED_TEST(Stability, OkMeansSixDigits) {
  using Model = typename TypeParam::Model;
  std::array<double, 3> worst{};
  this->on_each([&](double, const Member<Model>& member) {
    const Answer<Model> answer = generated<Model>(member.given);
    if (answer.status == Status::ok) {
      for (const Quantity quantity : quantities) {
        double& so_far = worst[static_cast<std::size_t>(quantity)];
        so_far = test::largest(so_far, error_of(answer, member.truth, quantity));
      }
    }
  });
  std::cout << TypeParam::name << ": largest error with status ok, sensitivities " << worst[0]
            << ", velocity " << worst[1] << ", acceleration " << worst[2] << '\n';
  EXPECT_LT(worst[0], 1e-6);
  EXPECT_LT(worst[1], 1e-6);
}

/// Otherwise a family would show nothing of its failure.
TYPED_TEST(Stability, FamilyComesToItsFailure) {
  using Family = TypeParam;
  constexpr bool regular = Family::largest_condition < any_condition;
  this->on_each([&](double distance, const Member<typename Family::Model>& member) {
    const double condition = member.truth.condition;
    if constexpr (regular) {
      EXPECT_LT(condition, regular_condition);
    } else {
      EXPECT_GT(condition, 0.1 / (std::is_same_v<Family, Fold> ? std::sqrt(distance) : distance));
    }
  });
}

/// The largest error of a method by distance; infinity where it failed on a member.
template <typename Family>
std::map<double, double> largest_errors(
    Answer<typename Family::Model> (*method)(const Geometry<typename Family::Model, double>&),
    Quantity quantity) {
  std::map<double, double> largest;
  for (const auto& [distance, number, member] : members_of<Family>()) {
    const auto answer = method(member.given);
    const double error = is_solvable(answer.status) ? error_of(answer, member.truth, quantity)
                                                    : std::numeric_limits<double>::infinity();
    largest[distance] = std::max(largest[distance], error);
  }
  return largest;
}

TEST(HalfAngleTangents, AccelerationsAreLostNearPi) {
  for (const auto& [distance, error] :
       largest_errors<HalfAngle>(half_angle<Model01>, Quantity::acceleration)) {
    EXPECT_GT(error, 0.2 * epsilon / distance) << distance;
  }
}

/// The tangent is exact to rounding, however large: J dtheta/dt dt is as well conditioned as J.
TEST(HalfAngleTangents, FirstDerivativesAreNot) {
  for (const Quantity quantity : {Quantity::sensitivities, Quantity::velocity}) {
    for (const auto& [distance, error] : largest_errors<HalfAngle>(half_angle<Model01>, quantity)) {
      EXPECT_LT(error, allowed_roundings * epsilon * regular_condition) << distance;
    }
  }
}

/// Even exact derivatives lose this much at a configuration that was assembled in double.
TEST(ComplexStep, PaysForAssemblingInDoubleNearAFold) {
  const auto complex = largest_errors<Fold>(complex_step<Model01>, Quantity::velocity);
  const auto direct = largest_errors<Fold>(generated<Model01>, Quantity::velocity);
  for (const double distance : {1e-8, 1e-10, 1e-12, 1e-14}) {
    EXPECT_GT(complex.lower_bound(distance * 0.5)->second, 0.01 * epsilon / distance) << distance;
    EXPECT_LT(direct.lower_bound(distance * 0.5)->second, 100 * epsilon / std::sqrt(distance))
        << distance;
  }
}

/// The number of members for which Newton's iteration settles, but on another configuration.
template <typename Family>
int landed_elsewhere() {
  using Model = typename Family::Model;
  int wrong = 0;
  for (const auto& [distance, number, member] : members_of<Family>()) {
    const auto answer = newton<Model>(member.given);
    wrong +=
        is_solvable(answer.status) && is_wrong(error_of(answer, member.truth, Quantity::velocity));
  }
  return wrong;
}

TEST(Newton, LandsOnAnotherBranchWithoutAWord) {
  constexpr int members = 300;
  EXPECT_GT(landed_elsewhere<Fold>(), members / 3);
  EXPECT_GT(landed_elsewhere<Crossing>(), members / 3);
  EXPECT_GT(landed_elsewhere<HalfAngle>(), 0);
}

TEST(CentralDifferences, NeverHaveMoreThanSixDigitsOfAllQuantities) {
  std::map<double, double> worst;
  for (const Quantity quantity : quantities) {
    for (const auto& [distance, error] :
         largest_errors<Units>(central_differences<Model04>, quantity)) {
      worst[distance] = std::max(worst[distance], error);
    }
    for (const auto& [distance, error] :
         largest_errors<SpecialPoint>(central_differences<Model01>, quantity)) {
      worst[distance] = std::max(worst[distance], error);
    }
  }
  for (const auto& [distance, error] : worst) {
    EXPECT_GT(error, 1e-7) << distance;
  }
}

/// By method, whether the status of spoilt input is not_finite.
TEST(BadInput, IsRefusedByTheRuntimeAndByNoBareSolver) {
  std::map<std::string, int> refused;
  for (const BadInputRow& row : bad_input_rows()) {
    refused[row.method] += row.status == Status::not_finite ? 1 : 0;
    EXPECT_FALSE(is_solvable(row.status) && row.finite && row.input != "input infinite")
        << row.method << ", " << row.input;
  }
  for (const char* method :
       {"generated", "Newton from a neighbour", "central differences", "special points"}) {
    EXPECT_EQ(refused[method], 4) << method;
  }
  for (const char* method : {"partial-pivot LU", "full-pivot LU", "automatic differentiation",
                             "complex step", "half-angle tangents"}) {
    EXPECT_EQ(refused[method], 0) << method;
  }
}

/// A step of the group's size vanishes beside a coordinate of 1e14.
TEST(CentralDifferences, LoseTheirStepFarFromTheOrigin) {
  const auto errors = largest_errors<FarAway>(central_differences<Model01>, Quantity::velocity);
  EXPECT_LT(errors.rbegin()->second, 1e-6);
  EXPECT_FALSE(errors.begin()->second < wrong_error);
}

/// Their lines become parallel while the group stays regular.
TEST(SpecialPoints, AreLostAtInfinity) {
  for (const Quantity quantity : {Quantity::velocity, Quantity::acceleration}) {
    for (const auto& [distance, error] :
         largest_errors<SpecialPoint>(special_points<Model01>, quantity)) {
      EXPECT_GT(error, 0.1 * epsilon / distance) << distance;
    }
  }
}

}  // namespace
}  // namespace assur::stability
