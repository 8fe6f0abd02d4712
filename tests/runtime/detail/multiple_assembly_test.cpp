// Law: an assembly at which several meet, and which is found only to a root of the rounding error,
// is moved to the place where they meet.
#include <gtest/gtest.h>

#include <array>
#include <assur/detail/multiple_assembly.hpp>
#include <cmath>

namespace assur::test::multiple_assembly_test {
namespace {

using detail::Closures;
using detail::FlatVariables;
using detail::Matrix4;
using detail::Vector4;

/// One length x with the closure (x - 1/3)^meeting = lift.
struct Meeting {
  int meeting;
  double lift = 0;

  static constexpr double place = 1.0 / 3;
  static constexpr std::array<ModelUnknown, 1> unknowns = {{{"x", false, 0}}};

  static void evaluate(const void* group, const FlatVariables<double>& q, Vector4& f) {
    const auto& self = *static_cast<const Meeting*>(group);
    f(0) = std::pow(q[0] - place, self.meeting) - self.lift;
  }
  static void differentiate(const void* group, const FlatVariables<double>& q, Matrix4& jacobian) {
    const int meeting = static_cast<const Meeting*>(group)->meeting;
    jacobian(0, 0) = meeting * std::pow(q[0] - place, meeting - 1);
  }
  [[nodiscard]] Closures closures() const {
    return {&evaluate, &differentiate, this, unknowns.data(), 1, 0, 0, 1};
  }
};

TEST(MultipleAssembly, SettlesWhereSeveralMeet) {
  // These distances from the meeting point are just below what rounding of the closure can resolve.
  constexpr std::array<double, 3> away = {4e-8, 1e-5, 2e-4};
  for (int meeting = 2; meeting <= 4; ++meeting) {
    for (const double side : {1.0, -1.0}) {
      const Meeting group{meeting};
      FlatVariables<double> q{};
      q[0] = Meeting::place + side * away[static_cast<std::size_t>(meeting - 2)];
      ASSERT_LT(norm(group.closures().at(q)), detail::rounding(group.closures(), q));
      detail::settle(group.closures(), q);
      EXPECT_NEAR(q[0], Meeting::place, 1e-12) << meeting << " meet";
    }
  }
}

/// Assemblies that are farther apart than rounding explains stay apart, although they are singular.
TEST(MultipleAssembly, StaysWhereNoneMeet) {
  constexpr double apart = 1e-5;
  const Meeting group{2, apart * apart};
  FlatVariables<double> q{};
  q[0] = Meeting::place + apart;
  ASSERT_LT(group.closures().jacobian(q)(0, 0), detail::singular_pivot);
  detail::settle(group.closures(), q);
  EXPECT_NEAR(q[0], Meeting::place + apart, 1e-14);
}

TEST(MultipleAssembly, PolynomialsPassThroughTheirValues) {
  // 2 - x + 3 x^2, about zero and about one.
  const std::array<double, 4> found = detail::interpolated<4>({-1, 0, 1, 2}, {6, 2, 4, 12});
  const std::array<double, 4> expected = {2, -1, 3, 0};
  EXPECT_EQ(found, expected);
  const std::array<double, 4> shifted = {4, 5, 3, 0};
  EXPECT_EQ(detail::shifted<4>(found, 1), shifted);
}

}  // namespace
}  // namespace assur::test::multiple_assembly_test
