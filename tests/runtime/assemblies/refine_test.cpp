// Law: Newton's refinement finds an assembly again from a fraction of a radian away, however short
// a bar is.
#include <gtest/gtest.h>

#include <assur/kinematics.hpp>
#include <assur/tetrad/model_01.hpp>

namespace assur::test::refine_test {
namespace {

using Model = tetrad::Model01;

/// RRR-RRR with the bar CD as given, assembled by choosing E and GF.
struct WithBar {
  Model::Dimensions<double> d = {2, 1, 1.2, 1.7, 0.8, -1.1, 0, 0};
  Model::Inputs<double> u;
  Model::Configuration<double> q = {direction_of(0.7), direction_of(1.9), direction_of(0.3), {}};

  explicit WithBar(double bar) {
    d.CD = bar;
    Vector<double, Model::equation_count> f;
    q.theta_GF = direction_of(0.0);
    Model::residual(d, u, q, f);
    u.x_E = f(0);
    u.y_E = f(1);
    Model::residual(d, u, q, f);
    d.GF = std::hypot(f(2), f(3));
    q.theta_GF = {-f(2) / d.GF, -f(3) / d.GF};
  }
};

TEST(Refine, ConvergesWithAShortBar) {
  for (const double bar : {1.0, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    for (const double turn : {0.01, 0.1, 0.3}) {
      const WithBar group(bar);
      Model::Configuration<double> q = group.q;
      advance(q, Vector<double, Model::unknown_count>(turn, -turn, turn, turn));
      EXPECT_TRUE(is_solvable(refine<Model, double>(group.d, group.u, q)))
          << "bar " << bar << ", turned by " << turn;
      Vector<double, Model::equation_count> f;
      Model::residual(group.d, group.u, q, f);
      EXPECT_LT(f.cwiseAbs().maxCoeff(), 1e-14);
    }
  }
}

}  // namespace
}  // namespace assur::test::refine_test
