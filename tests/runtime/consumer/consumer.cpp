// Uses the generated solver of an RRR-RRR tetrad from an install tree, without access to GiNaC.
#include <assur/kinematics.hpp>
#include <assur/tetrad/model_01.hpp>
#include <cmath>
#include <cstdio>

#if __has_include(<ginac/ginac.h>) && defined(GINAC_GINAC_H)
#error "the runtime includes GiNaC"
#endif

int main() {
  using Model = assur::tetrad::Model01;
  // A tetrad of known shape: B, C, G and E, D, F placed, the bars CD and GF between them.
  Model::Dimensions<double> d;
  d.BC = 3;
  d.x_G_BCG = 1;
  d.y_G_BCG = 2;
  d.ED = 2;
  d.x_F_EDF = 2;
  d.y_F_EDF = -1;
  Model::Inputs<double> u;
  u.x_E = 7;
  u.y_E = 1;
  Model::Configuration<double> q;
  q.theta_BCG = assur::direction_of(0.3);
  q.theta_EDF = assur::direction_of(1.9);
  // Lengths and directions of the bars follow from the points that they join.
  const double cx = 3 * std::cos(0.3) - (7 + 2 * std::cos(1.9));
  const double cy = 3 * std::sin(0.3) - (1 + 2 * std::sin(1.9));
  const double gx = std::cos(0.3) - 2 * std::sin(0.3) - (7 + 2 * std::cos(1.9) + std::sin(1.9));
  const double gy = std::sin(0.3) + 2 * std::cos(0.3) - (1 + 2 * std::sin(1.9) - std::cos(1.9));
  d.CD = std::hypot(cx, cy);
  d.GF = std::hypot(gx, gy);
  q.theta_CD = {-cx / d.CD, -cy / d.CD};
  q.theta_GF = {-gx / d.GF, -gy / d.GF};
  assur::advance(q, assur::Vector<double, 4>(0.02, -0.03, 0.01, 0.02));

  const assur::Status status = assur::refine<Model, double>(d, u, q);
  std::printf("%s, theta_BCG = %.12f\n", assur::to_string(status), assur::angle_of(q.theta_BCG));
  const bool found = std::abs(assur::angle_of(q.theta_BCG) - 0.3) < 1e-12;
  return status == assur::Status::ok && found ? 0 : 1;
}
