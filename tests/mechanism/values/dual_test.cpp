// Law: every function of dual numbers follows the chain rule to second order.
#include <gtest/gtest.h>

#include <array>
#include <assur/mechanism/dual.hpp>
#include <assur/mechanism/formula.hpp>
#include <cmath>
#include <limits>

#include "richardson.hpp"

namespace assur::test::dual_test {
namespace {

using mechanism::Dual;
using mechanism::Formula;
using mechanism::ParameterIndex;

/// Every function of expressions, alone: gradients and Hessians against differences.
TEST(DualNumbers, FollowTheChainRuleToSecondOrder) {
  constexpr std::array<const char*, 22> functions = {"x + y",       "x - y",
                                                     "-x",          "x*y",
                                                     "x/y",         "2/x",
                                                     "x/2",         "sqrt(x)",
                                                     "sin(x)",      "cos(x)",
                                                     "tan(x)",      "asin(x)",
                                                     "acos(x)",     "atan(x)",
                                                     "atan2(x, y)", "atan2(-x, -y)",
                                                     "atan2(y, 2)", "x^3",
                                                     "x^(-0.5)",    "x^y",
                                                     "(x*y)^(x/y)", "sin(x*y)/(2 + cos(x))"};
  const Eigen::Vector2d place(0.37, 0.83);
  for (const char* function : functions) {
    const Formula formula(
        text::parse_expression(function),
        {[](const std::string& name) { return ParameterIndex(name == "x" ? 0U : 1U); }, nullptr});
    const auto at = [&](const Eigen::Vector2d& point) {
      return formula.evaluate<Dual>([&](ParameterIndex parameter) {
        const Eigen::Index index = parameter.row();
        return Dual(point(index), Eigen::Vector2d::Unit(index), Eigen::Matrix2d::Zero());
      });
    };
    const Dual derived = at(place);
    for (Eigen::Index index = 0; index < 2; ++index) {
      const auto difference = richardson<Eigen::Vector3d>(
          [&](double offset) {
            const Dual moved = at(place + offset * Eigen::Vector2d::Unit(index));
            return Eigen::Vector3d(moved.value(), moved.derivatives()(0), moved.derivatives()(1));
          },
          1e-2);
      Eigen::Vector3d expected;
      expected << derived.derivatives()(index), derived.hessian().col(index);
      EXPECT_LT((difference.derivative - expected).norm(), 1e-9 * (1 + expected.norm()))
          << function;
    }
  }
}

TEST(DualNumbers, PowersOfZeroHaveTheDerivativesOfPolynomials) {
  const Dual zero(0.0, Eigen::VectorXd::Ones(1), Eigen::MatrixXd::Zero(1, 1));
  const std::array<double, 4> second = {0, 0, 2, 0};
  for (int exponent = 0; exponent < 4; ++exponent) {
    const Dual power = pow(zero, exponent);
    EXPECT_EQ(power.derivatives()(0), exponent == 1 ? 1 : 0) << exponent;
    EXPECT_EQ(power.hessian()(0, 0), second[static_cast<std::size_t>(exponent)]) << exponent;
  }
}

/// A power x^n with its derivatives by x and n, as they are exactly; NaN where there is none.
struct Power {
  double x, n;
  double value, by_x, by_n, by_xx, by_xn, by_nn;
};

class DualPower : public testing::TestWithParam<Power> {};

TEST_P(DualPower, HasTheDerivativesThatThereAre) {
  const Power& exact = GetParam();
  const Dual x(exact.x, Eigen::Vector2d::Unit(0), Eigen::Matrix2d::Zero());
  const Dual n(exact.n, Eigen::Vector2d::Unit(1), Eigen::Matrix2d::Zero());
  const auto expect = [](double found, double truth) {
    if (std::isnan(truth)) {
      EXPECT_TRUE(std::isnan(found)) << found;
    } else {
      EXPECT_DOUBLE_EQ(found, truth);
    }
  };
  const Dual power = pow(x, n);
  expect(power.value(), exact.value);
  expect(power.derivatives()(0), exact.by_x);
  expect(power.derivatives()(1), exact.by_n);
  expect(power.hessian()(0, 0), exact.by_xx);
  expect(power.hessian()(0, 1), exact.by_xn);
  expect(power.hessian()(1, 0), exact.by_xn);
  expect(power.hessian()(1, 1), exact.by_nn);
}

const double none = std::numeric_limits<double>::quiet_NaN();
const double ln2 = std::log(2.0);
INSTANTIATE_TEST_SUITE_P(
    Powers, DualPower,
    testing::Values(
        Power{-2, 2, 4, -4, none, 2, none, none}, Power{-2, 3, -8, 12, none, -12, none, none},
        Power{-2, 1, -2, 1, none, 0, none, none}, Power{-2, 0, 1, 0, none, 0, none, none},
        Power{-2, -1, -0.5, -0.25, none, -0.25, none, none}, Power{0, 3, 0, 0, 0, 0, 0, 0},
        Power{0, 2, 0, 0, 0, 2, 0, 0}, Power{0, 0, 1, 0, none, 0, none, none},
        Power{2, 2, 4, 4, 4 * ln2, 2, 2 + 4 * ln2, 4 * ln2* ln2},
        Power{4, 0.5, 2, 0.25, 4 * ln2, -1. / 32, 0.5 * (1 + ln2), 8 * ln2* ln2}));

TEST(DualNumbers, PowersThatThereAreNotAreNotNumbers) {
  const Dual third(1. / 3, Eigen::VectorXd::Ones(1), Eigen::MatrixXd::Zero(1, 1));
  EXPECT_TRUE(std::isnan(pow(Dual(-8.0), third).value()));
  EXPECT_TRUE(std::isinf(pow(Dual(0.0), -third).value()));
}

}  // namespace
}  // namespace assur::test::dual_test
