// Law: every function of dual numbers follows the chain rule to second order.
#include <gtest/gtest.h>

#include <array>
#include <assur/mechanism/dual.hpp>
#include <assur/mechanism/formula.hpp>

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

}  // namespace
}  // namespace assur::test::dual_test
