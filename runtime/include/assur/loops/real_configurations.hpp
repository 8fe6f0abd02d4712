// The real configurations of a group among its complex ones, and what moves where it is in special
// position.
#pragma once

#include <algorithm>
#include <assur/loops/enclosure.hpp>
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

/// Gauss and Newton's steps with damping, by Levenberg and Marquardt, to where the closures are
/// least; each step is measured with displacements in parts of the size.
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

/// The real configurations of a group.
template <typename Of>
struct RealConfigurations {
  BoundedList<ComplexConfiguration<Of>, Of::configurations> list;
  int complex_count = 0;  ///< the number of complex configurations that are enclosed
  int mobility = 0;       ///< the greatest of a family
};

/// Real configurations among those that are not enclosed, and the mobility of what moves.
template <typename Of>
class UnprovenConfigurations {
 public:
  UnprovenConfigurations(const LoopEquations<Of>& equations, const AllConfigurations<Of>& all,
                         RealConfigurations<Of>& result)
      : equations_(equations), all_(all), size_(equations.size()), result_(result) {
    for (const ComplexConfiguration<Of>& at : all.unproven) {
      include(made_real(at));
    }
  }

 private:
  /// Where a configuration is not enclosed, rounding moves it by the root of a rounding, or more
  /// where more than two meet.
  [[nodiscard]] static double apart() { return std::cbrt(epsilon); }

  [[nodiscard]] double gap_between(const ComplexConfiguration<Of>& one,
                                   const ComplexConfiguration<Of>& other) const {
    return (std::max)(norm_of(one.theta - other.theta), norm_of(one.s - other.s) / size_);
  }

  void include(const ComplexConfiguration<Of>& near) {
    if (!near.theta.allFinite() || !near.s.allFinite() || result_.list.is_full()) {
      return;
    }
    const ComplexConfiguration<Of> at = settled(equations_, near);
    const RealClosures<Of> here = real_closures(equations_, at);
    if (!(here.f.norm() <= rounding_of(equations_, at)) || gap_between(at, near) > apart() * 100) {
      return;
    }
    for (const ComplexConfiguration<Of>& other : result_.list) {
      if (gap_between(at, other) < apart()) {
        return;
      }
    }
    for (const Enclosed<Of>& other : all_.enclosed) {
      if (gap_between(at, other.at) < apart()) {
        return;
      }
    }
    if (const int freedoms = mobility_at(at, here); freedoms > 0) {
      result_.mobility = (std::max)(result_.mobility, freedoms);
    } else {
      result_.list.push_back(at);
    }
  }

  /// How many directions of the kernel lead to configurations that close as well.
  [[nodiscard]] int mobility_at(const ComplexConfiguration<Of>& at,
                                const RealClosures<Of>& here) const {
    constexpr double step = 0x1p-7;  // radians: the closures of an isolated one open by its square
    const Eigen::Index angles = equations_.angle_count();
    typename Of::Square in_size = here.j;
    in_size.leftCols(angles) /= size_;
    const Eigen::Index unknowns = in_size.cols();
    SmallSystem<Of, double> system(unknowns, unknowns);
    system.put(0, in_size);
    (void)system.eliminate_above(apart(), unknowns);
    int result = 0;
    for (Eigen::Index free = 0; free < unknowns; ++free) {
      if (system.row_of(free) >= 0) {
        continue;
      }
      typename Of::Closures along(unknowns);
      for (Eigen::Index unknown = 0; unknown < unknowns; ++unknown) {
        const int row = system.row_of(unknown);
        along(unknown) = row >= 0 ? -system.entry(row, free) : unknown == free ? 1.0 : 0.0;
      }
      along *= step / along.norm();
      along.tail(unknowns - angles) *= size_;
      const ComplexConfiguration<Of> there =
          settled(equations_, made_real(stepped<Of>(at, along.template cast<Complex>())));
      const bool closes =
          real_closures(equations_, there).f.norm() <= rounding_of(equations_, there);
      result += closes && gap_between(there, at) > step / 4 ? 1 : 0;
    }
    return result;
  }

  const LoopEquations<Of>& equations_;
  const AllConfigurations<Of>& all_;
  double size_;
  RealConfigurations<Of>& result_;
};

/// The real configurations of a group with `complex_count` complex ones in general position.
template <typename Of, typename Eliminations>
[[nodiscard]] RealConfigurations<Of> real_configurations(const LoopEquations<Of>& equations,
                                                         const Eliminations& eliminations,
                                                         int complex_count) {
  const AllConfigurations<Of> all = all_configurations(equations, eliminations, complex_count);
  RealConfigurations<Of> result;
  result.complex_count = all.count();
  for (const Enclosed<Of>& one : all.enclosed) {
    if (one.is_real) {
      result.list.push_back(made_real(one.at));
    }
  }
  if (all.count() < complex_count) {
    UnprovenConfigurations<Of>(equations, all, result);
  }
  return result;
}

}  // namespace assur::loops
