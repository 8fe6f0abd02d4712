// Law: a magnitude is no smaller than the number that it stands for, its rounding no smaller than
// the error of that number in doubles, and neither is much larger.
#include <gtest/gtest.h>

#include <algorithm>
#include <assur/numeric/magnitude.hpp>
#include <cmath>
#include <iostream>
#include <random>

#include "runtime/exact.hpp"

namespace assur::test::magnitude_test {
namespace {

using numeric::Magnitude;

constexpr unsigned seed = 14142;

/// A number in doubles, as it is exactly, and its magnitude.
struct Known {
  double number;
  Rational truth;
  Magnitude magnitude;
};

TEST(Magnitude, BoundsTheNumberAndItsError) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> numbers(0.5, 2);
  const auto given = [&] {
    const double number = numbers(engine);
    return Known{number, exact(number), Magnitude(number, 0)};
  };
  double largest_part = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    Known value = given();
    for (int step = 0; step < 6; ++step) {
      const Known by = given();
      switch (engine() % 3) {
        case 0:
          value = {value.number + by.number, value.truth + by.truth,
                   value.magnitude + by.magnitude};
          break;
        case 1:
          value = {value.number * by.number, value.truth * by.truth,
                   value.magnitude * by.magnitude};
          break;
        default:
          value = {value.number / by.number, value.truth / by.truth,
                   value.magnitude / by.magnitude};
      }
    }
    const Rational difference = exact(value.number) - value.truth;
    const double error = std::abs(difference.rounded());
    EXPECT_LE(error, value.magnitude.rounding());
    // All numbers are positive, so that the size is the number, and each of the six operations adds
    // one size to the units.
    EXPECT_NEAR(value.magnitude.size, value.number, 1e-14 * value.number);
    EXPECT_LE(value.magnitude.units, 6 * (1 + 1e-14) * value.number);
    largest_part = std::max(largest_part, error / value.magnitude.rounding());
  }
  std::cout << "seed " << seed << ": the largest error is " << largest_part << " of its bound\n";
  EXPECT_GT(largest_part, 0.5);
}

TEST(Magnitude, RoundsAnEighthMoreThanItsUnits) {
  EXPECT_EQ(Magnitude(1.0, 8.0).rounding(), 9 * 0x1p-53);
}

TEST(Magnitude, OfADifferenceIsThatOfTheSum) {
  const Magnitude difference = Magnitude(3.0, 1.0) - Magnitude(2.0, 4.0);
  EXPECT_EQ(difference.size, 5);
  EXPECT_EQ(difference.units, 10);
}

TEST(Magnitude, HasNoBoundBehindADivisorThatMayVanish) {
  EXPECT_EQ((Magnitude(1) / Magnitude(1.0, 2.0)).size, std::numeric_limits<double>::infinity());
  EXPECT_EQ((Magnitude(3) / Magnitude(2)).size, 1.5);
}

}  // namespace
}  // namespace assur::test::magnitude_test
