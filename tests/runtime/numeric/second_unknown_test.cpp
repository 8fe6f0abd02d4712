// Law: the values of the second unknown that satisfy both reduced equations come before those that
// satisfy only one of them, whatever factors the equations are multiplied by.
#include <gtest/gtest.h>

#include <assur/directions.hpp>
#include <assur/numeric/second_unknown.hpp>
#include <cmath>
#include <random>

namespace assur::test::second_unknown_test {
namespace {

using Equations = Matrix<double, 2, 3>;
using numeric::common_root;
using numeric::second_candidates;

constexpr unsigned seed = 31415;

/// Two lines a cos z + b sin z + c = 0 through one point of the circle.
Equations lines_through(const Direction<double>& z, std::mt19937& random) {
  std::uniform_real_distribution<double> number(-2, 2);
  Equations e;
  for (int row = 0; row < 2; ++row) {
    e(row, 0) = number(random);
    e(row, 1) = number(random);
    e(row, 2) = -(e(row, 0) * z.cos + e(row, 1) * z.sin);
  }
  return e;
}

TEST(SecondUnknown, OfTwoLinesIsTheirCommonDirection) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> angle(-3, 3);
  for (int trial = 0; trial < 1000; ++trial) {
    const auto z = direction_of(angle(random));
    const auto found = second_candidates<Direction<double>>(lines_through(z, random));
    ASSERT_GE(found.count, 2U);
    // A line that nearly touches the circle tells the direction to half of the digits.
    EXPECT_NEAR(found.list[0].value.cos, z.cos, 1e-7) << trial;
    EXPECT_NEAR(found.list[0].value.sin, z.sin, 1e-7) << trial;
    for (std::size_t index = 0; index < found.count; ++index) {
      const Direction<double>& value = found.list[index].value;
      EXPECT_NEAR(std::hypot(value.cos, value.sin), 1, 1e-15);
      EXPECT_TRUE(index == 0 || found.list[index - 1].miss <= found.list[index].miss);
    }
  }
}

/// A direction along an axis has a part that vanishes.
TEST(SecondUnknown, MayLieAlongAnAxis) {
  Equations e;
  e << 2, 1, -2, 1, -3, -1;  // both lines pass through (1, 0)
  const auto found = second_candidates<Direction<double>>(e);
  ASSERT_GE(found.count, 2U);
  EXPECT_EQ(found.list[0].value.cos, 1);
  EXPECT_EQ(found.list[0].value.sin, 0);
}

/// The line that cuts the circle at a larger angle tells the direction to more digits.
TEST(SecondUnknown, ComesFromTheLineThatDeterminesItBetter) {
  const double touching = 1 - 1e-9;
  for (const bool exchanged : {false, true}) {
    Equations e;
    e.row(exchanged ? 1 : 0) << 1, 0, -touching;
    e.row(exchanged ? 0 : 1) << 0, 1, -std::sqrt(1 - touching * touching) * (1 + 1e-6);
    const auto found = second_candidates<Direction<double>>(e);
    ASSERT_EQ(found.count, 2U);
    EXPECT_EQ(found.list[0].value.sin, -e(exchanged ? 0 : 1, 2));
  }
}

TEST(SecondUnknown, OfTwoParabolasIsTheirCommonRoot) {
  Equations e;
  e << 1, -3, 2, 2, -12, 10;  // (z - 1)(z - 2) and 2 (z - 1)(z - 5)
  const auto found = second_candidates<double>(e);
  ASSERT_EQ(found.count, 4U);
  EXPECT_EQ(found.list[0].value, 1);
  EXPECT_EQ(found.list[1].value, 1);
  EXPECT_EQ(found.list[0].miss, 0);
  EXPECT_GT(found.list[2].miss, 0.01);
}

TEST(SecondUnknown, MissesByTheSameInAnyUnit) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-2, 2);
  for (int trial = 0; trial < 100; ++trial) {
    const Equations e = Equations::NullaryExpr([&] { return number(random); });
    const Equations larger = 1024 * e;
    const auto expect_same = [](const auto& one, const auto& other) {
      ASSERT_EQ(one.count, other.count);
      for (std::size_t index = 0; index < one.count; ++index) {
        EXPECT_EQ(one.list[index].miss, other.list[index].miss);
      }
    };
    expect_same(second_candidates<double>(e), second_candidates<double>(larger));
    expect_same(second_candidates<Direction<double>>(e),
                second_candidates<Direction<double>>(larger));
  }
}

TEST(SecondUnknown, FollowsFromBothEquationsAtOnce) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> angle(-3, 3);
  for (int trial = 0; trial < 1000; ++trial) {
    const auto z = direction_of(angle(random));
    const Equations e = lines_through(z, random);
    const double determinant = e(0, 0) * e(1, 1) - e(0, 1) * e(1, 0);
    const auto found = common_root<Direction<double>>(e);
    EXPECT_NEAR(found.cos, z.cos, 1e-14 / std::abs(determinant));
    EXPECT_NEAR(found.sin, z.sin, 1e-14 / std::abs(determinant));
  }
  Equations parabolas;
  parabolas << 1, -3, 2, 2, -12, 10;
  EXPECT_EQ(common_root<double>(parabolas), 1);
  Equations straight;
  straight << 0, 2, -6, 0, -1, 3;  // z = 3 twice, without squares
  EXPECT_EQ(common_root<double>(straight), 3);
}

}  // namespace
}  // namespace assur::test::second_unknown_test
