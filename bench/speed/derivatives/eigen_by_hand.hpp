// The loop closures of an RRR-RRR tetrad and their derivatives, written out as an engineer would.
#pragma once

#include "derivatives/derivative_errors.hpp"

namespace assur::speed {

/// The links' vectors from directions; every closure, Jacobian and right-hand side is made of them.
struct HandVectors {
  using V = Eigen::Vector2d;
  V BC, BG, ED, EF, CD, GF;

  HandVectors(const Model01::Dimensions<double>& d, const Eigen::Vector4d& c,
              const Eigen::Vector4d& s) {
    const auto turned = [&](int link, double x, double y) {
      return V(c(link) * x - s(link) * y, s(link) * x + c(link) * y);
    };
    const auto along = [&](int link, double x) { return V(c(link) * x, s(link) * x); };
    BC = along(0, d.BC);
    BG = turned(0, d.x_G_BCG, d.y_G_BCG);
    ED = along(1, d.ED);
    EF = turned(1, d.x_F_EDF, d.y_F_EDF);
    CD = along(2, d.CD);
    GF = along(3, d.GF);
  }

  [[nodiscard]] Eigen::Matrix4d jacobian() const {
    Eigen::Matrix4d J;
    J << -BC.y(), ED.y(), -CD.y(), 0,  //
        BC.x(), -ED.x(), CD.x(), 0,    //
        -BG.y(), EF.y(), 0, -GF.y(),   //
        BG.x(), -EF.x(), 0, GF.x();
    return J;
  }
  [[nodiscard]] Eigen::Vector4d closure(const Model01::Inputs<double>& u) const {
    const V base(u.x_B - u.x_E, u.y_B - u.y_E);
    Eigen::Vector4d f;
    f << base + BC + CD - ED, base + BG + GF - EF;
    return f;
  }
  /// d2f/dt2 with the second rates of the unknowns left out.
  [[nodiscard]] Eigen::Vector4d second_derivative(const Eigen::Vector4d& velocity,
                                                  const Eigen::Vector4d& u_second_rate) const {
    const Eigen::Vector4d w = velocity.cwiseAbs2();
    const V a = u_second_rate.head<2>() - u_second_rate.tail<2>();
    Eigen::Vector4d f;
    f << a - BC * w(0) - CD * w(2) + ED * w(1), a - BG * w(0) - GF * w(3) + EF * w(1);
    return f;
  }
};

/// df/dd and df/du.
inline void hand_parameters(const Eigen::Vector4d& c, const Eigen::Vector4d& s,
                            ClosureAnswer<double>& f) {
  f.by_dimensions << c(0), 0, 0, -c(1), 0, 0, c(2), 0,  //
      s(0), 0, 0, -s(1), 0, 0, s(2), 0,                 //
      0, c(0), -s(0), 0, -c(1), s(1), 0, c(3),          //
      0, s(0), c(0), 0, -s(1), -c(1), 0, s(3);
  f.by_inputs << 1, 0, -1, 0,  //
      0, 1, 0, -1,             //
      1, 0, -1, 0,             //
      0, 1, 0, -1;
}

}  // namespace assur::speed
