// Real configurations near given ones with the least closure residual.
#pragma once

#include <assur/loops/loop_equations.hpp>
#include <assur/loops/small_systems.hpp>
#include <cmath>

namespace assur::loops {

/// The configuration nearest to a complex one among those with real angles and displacements.
template <typename Of>
[[nodiscard]] ComplexConfiguration<Of> made_real(ComplexConfiguration<Of> at) {
  for (Eigen::Index angle = 0; angle < at.theta.size(); ++angle) {
    at.theta(angle) /= std::abs(at.theta(angle));
  }
  for (Eigen::Index slide = 0; slide < at.s.size(); ++slide) {
    at.s(slide) = at.s(slide).real();
  }
  return at;
}

/// The closures, x of all loops and then y, and their derivatives to real angles and displacements.
template <typename Of>
struct RealClosures {
  typename Of::Closures f;
  typename Of::Square j;
};

template <typename Of>
[[nodiscard]] RealClosures<Of> real_closures(const LoopEquations<Of>& equations,
                                             const ComplexConfiguration<Of>& at) {
  const Eigen::Index loops = equations.loop_count();
  const typename Of::ComplexClosures f = closures_at(equations, at);
  const typename Of::ComplexSquare j = jacobian_at(equations, at);
  RealClosures<Of> result{typename Of::Closures(2 * loops),
                          typename Of::Square(2 * loops, 2 * loops)};
  result.f << f.head(loops).real(), f.head(loops).imag();
  result.j << j.topRows(loops).real(), j.topRows(loops).imag();
  return result;
}

/// The configuration of least closure residual by damped Gauss-Newton steps (Levenberg-Marquardt);
/// steps are measured with displacements divided by the size.
template <typename Of>
[[nodiscard]] ComplexConfiguration<Of> settled(const LoopEquations<Of>& equations,
                                               ComplexConfiguration<Of> at) {
  constexpr int most_steps = 100;
  double damping = 1e-3;
  RealClosures<Of> here = real_closures(equations, at);
  for (int step = 0; step < most_steps; ++step) {
    typename Of::Square square = here.j.transpose().lazyProduct(here.j);
    square.diagonal().array() += damping * square.diagonal().maxCoeff();
    const typename Of::Closures rhs = -here.j.transpose().lazyProduct(here.f);
    const typename Of::Closures by = solved<Of>(square, rhs);
    const ComplexConfiguration<Of> next = made_real(stepped<Of>(at, by.template cast<Complex>()));
    const RealClosures<Of> there = real_closures(equations, next);
    if (there.f.norm() < here.f.norm()) {
      at = next;
      here = there;
      damping /= 10;
    } else if (damping > 1e6) {
      break;
    } else {
      damping *= 10;
    }
  }
  return at;
}

}  // namespace assur::loops
