// Law: a configuration that polishing calls assembled closes to a few roundings.
#include <gtest/gtest.h>

#include <assur/detail/polish.hpp>
#include <assur/dyad/model_01.hpp>
#include <cmath>
#include <limits>

namespace assur::test::polish_test {
namespace {

using Model = dyad::Model01;

/// Two bars between B at the origin and D.
Status polished(double x_D, double first, double second, Model::Configuration<double>& q) {
  q = {direction_of(first), direction_of(second)};
  return detail::polish<Model, double>({0.5, 0.625}, {0, 0, x_D, 0}, q, 0, 0);
}

TEST(Polish, ClosesWhatNearlyCloses) {
  Model::Configuration<double> q;
  // Bars of 1/2 and 5/8 over a base of 7/8, from a hundred-thousandth of a radian away.
  const double first = std::acos((0.25 + 0.765625 - 0.390625) / 0.875);
  const double second = -std::asin(0.5 * std::sin(first) / 0.625);
  for (const double off : {0.0, 1e-9, 1e-5}) {
    EXPECT_EQ(polished(0.875, first + off, second - off, q), Status::ok);
    Vector<double, 2> f;
    Model::residual<double>({0.5, 0.625}, {0, 0, 0.875, 0}, q, f);
    EXPECT_LE(f.cwiseAbs().maxCoeff(), detail::polished_rounding(1.0));
  }
}

TEST(Polish, RefusesWhatDoesNotClose) {
  Model::Configuration<double> q;
  EXPECT_EQ(polished(1.5, 0.5, -0.5, q), Status::no_convergence);  // out of reach
  // From far away, three steps with one Jacobian reach only a few digits.
  EXPECT_EQ(polished(0.875, 0.9, -0.6, q), Status::no_convergence);
  q.theta_BC.cos = std::numeric_limits<double>::quiet_NaN();
  const Model::Configuration<double> none = q;
  EXPECT_EQ((detail::polish<Model, double>({0.5, 0.625}, {0, 0, 0.875, 0}, q, 0, 0)),
            Status::no_convergence);
  EXPECT_EQ(q.theta_CD.sin, none.theta_CD.sin);
}

}  // namespace
}  // namespace assur::test::polish_test
