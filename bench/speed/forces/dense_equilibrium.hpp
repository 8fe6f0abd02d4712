// Joint forces of a group of pinned links by dense LU of three equilibrium equations per link.
#pragma once

#include <Eigen/LU>
#include <array>
#include <assur/dyad/model_01.hpp>
#include <assur/tetrad/model_01.hpp>

namespace assur::speed {

/// One joint on one link: its position from the origin of the link's frame, in the directions of
/// the fixed frame. The sign is 1 on the second link of the joint, on which the joint's force acts.
template <typename Scalar>
struct PinOnLink {
  int joint, link, sign;
  Scalar x, y;
};

template <typename Scalar>
[[nodiscard]] inline PinOnLink<Scalar> pin(int joint, int link, int sign,
                                           const Direction<Scalar>& turn, const Scalar& x,
                                           const Scalar& y) {
  return {joint, link, sign, turn.cos * x - turn.sin * y, turn.sin * x + turn.cos * y};
}

template <typename Scalar>
[[nodiscard]] inline std::array<PinOnLink<Scalar>, 4> pins(
    const dyad::Model01::Dimensions<Scalar>& d, const dyad::Model01::Configuration<Scalar>& q) {
  const Scalar zero(0);
  return {{{0, 0, 1, zero, zero},
           pin(1, 0, -1, q.theta_BC, d.BC, zero),
           {1, 1, 1, zero, zero},
           pin(2, 1, 1, q.theta_CD, d.CD, zero)}};
}

template <typename Scalar>
[[nodiscard]] inline std::array<PinOnLink<Scalar>, 10> pins(
    const tetrad::Model01::Dimensions<Scalar>& d, const tetrad::Model01::Configuration<Scalar>& q) {
  const Scalar zero(0);
  return {{{0, 0, 1, zero, zero},
           pin(1, 0, -1, q.theta_BCG, d.BC, zero),
           pin(2, 0, -1, q.theta_BCG, d.x_G_BCG, d.y_G_BCG),
           {3, 1, 1, zero, zero},
           pin(4, 1, -1, q.theta_EDF, d.ED, zero),
           pin(5, 1, -1, q.theta_EDF, d.x_F_EDF, d.y_F_EDF),
           {1, 2, 1, zero, zero},
           pin(4, 2, 1, q.theta_CD, d.CD, zero),
           {2, 3, 1, zero, zero},
           pin(5, 3, 1, q.theta_GF, d.GF, zero)}};
}

/// The forces, rows (x, y) joint by joint, under loads (x, y, moment) on each link about the origin
/// of its frame.
template <typename Model, typename Scalar>
[[nodiscard]] Matrix<Scalar, Model::joint_count, 2> dense_forces(
    const typename Model::template Dimensions<Scalar>& d,
    const typename Model::template Configuration<Scalar>& q,
    const Matrix<Scalar, Model::link_count, 3>& loads) {
  constexpr int rows = 3 * Model::link_count;
  static_assert(2 * Model::joint_count == rows, "a group of pinned links has as many forces");
  Matrix<Scalar, rows, rows> A;
  A.setZero();
  for (const PinOnLink<Scalar>& at : pins<Scalar>(d, q)) {
    const Scalar sign(at.sign);
    A(3 * at.link, 2 * at.joint) = sign;
    A(3 * at.link + 1, 2 * at.joint + 1) = sign;
    A(3 * at.link + 2, 2 * at.joint) = -sign * at.y;
    A(3 * at.link + 2, 2 * at.joint + 1) = sign * at.x;
  }
  Vector<Scalar, rows> b;
  for (int row = 0; row < rows; ++row) {
    b(row) = -loads(row / 3, row % 3);
  }
  const Vector<Scalar, rows> x = A.partialPivLu().solve(b);
  Matrix<Scalar, Model::joint_count, 2> forces;
  for (int joint = 0; joint < Model::joint_count; ++joint) {
    forces.row(joint) = x.template segment<2>(2 * joint);
  }
  return forces;
}

}  // namespace assur::speed
