// Law: words of two floats err by no more than is proven of them, and floats are told from doubles.
#include <gtest/gtest.h>

#include <assur/numeric/arithmetic.hpp>
#include <assur/numeric/bounded.hpp>
#include <cmath>
#include <random>

#include "largest.hpp"

namespace assur::test::double_float_test {
namespace {

using numeric::DoubleFloat;

constexpr double unit = 0x1p-24;

double value_of(const DoubleFloat& word) {
  return static_cast<double>(word.high) + static_cast<double>(word.low);
}
/// The error in squares of the unit; double holds the truth to a thirtieth of one.
double error_of(const DoubleFloat& word, double truth) {
  return std::abs(value_of(word) - truth) / (std::abs(truth) * unit * unit);
}

TEST(DoubleFloat, ErrsByNoMoreThanIsProven) {
  std::mt19937 random(24);
  std::uniform_real_distribution<double> draw(-2, 2);
  double sum = 0;
  double product = 0;
  double quotient = 0;
  double root = 0;
  for (int sample = 0; sample < 100000; ++sample) {
    const DoubleFloat a(draw(random));
    const DoubleFloat b(draw(random));
    const double one = value_of(a);
    const double other = value_of(b);
    // Where much cancels, double rounds the sum itself by more.
    sum = std::abs(one + other) > 1e-4 ? largest(sum, error_of(a + b, one + other)) : sum;
    product = largest(product, error_of(a * b, one * other));
    quotient = largest(quotient, error_of(a / b, one / other));
    root = one > 0 ? largest(root, error_of(sqrt(a), std::sqrt(one))) : root;
  }
  EXPECT_LT(sum, 3.1);
  EXPECT_LT(product, 5.1);
  EXPECT_LT(quotient, 15.1);
  EXPECT_LT(root, 25.0 / 8 + 0.1);
  EXPECT_GT(product, 1);  // otherwise something else was measured
}

TEST(DoubleFloat, ExactSumsAreToldOfEachScalar) {
  EXPECT_TRUE(numeric::sums_are_exact<float>());
  EXPECT_TRUE(numeric::sums_are_exact<double>());
  EXPECT_TRUE(numeric::keeps_subnormals<float>());
}

TEST(DoubleFloat, BoundsCountWhatAConstantLosesInFloat) {
  using Certified = numeric::Bounded<float>;
  EXPECT_GE(static_cast<double>(Certified(0.1).bound), std::abs(static_cast<double>(0.1F) - 0.1));
  const Certified third = Certified(1) / Certified(3.1);
  EXPECT_GE(static_cast<double>(third.certain_bound()),
            std::abs(static_cast<double>(third.value) - 1 / 3.1));
}

}  // namespace
}  // namespace assur::test::double_float_test
