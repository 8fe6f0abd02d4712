// Parameter continuation of a group's complex configurations from those of the same group with
// other numbers.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <assur/loops/loop_equations.hpp>
#include <assur/loops/small_systems.hpp>
#include <assur/loops/start.hpp>
#include <cmath>
#include <limits>

namespace assur::loops {

/// The homotopy H(z, t) = turn (1 - t) f(z) + t g(z) from the closures f with some numbers to the
/// closures g with others, and the paths of its configurations z(t), 0 <= t <= 1. Closures are
/// linear in a group's numbers, so every H belongs to the same group, with complex numbers; for
/// almost every `turn` no two paths meet before t = 1.
template <typename Of>
class ParameterPath {
  using At = ComplexConfiguration<Of>;
  using Step = typename Of::ComplexClosures;

 public:
  ParameterPath(const LoopEquations<Of>& from, const LoopEquations<Of>& to, const Complex& turn)
      : from_(from), to_(to), turn_(turn) {}

  /// Follows the path of a configuration to t = 1, or until it comes close to a multiple
  /// configuration or to infinity. Returns whether t = 1 was reached.
  bool follow(At& at) const {
    constexpr int most_steps = 400;  // paths take about 20
    constexpr double first_step = 0.05;
    constexpr double shortest_step = 1e-10;  // in t; below this rounding bends a path
    double t = 0;
    double length = first_step;
    for (int step = 0; step < most_steps && length > shortest_step; ++step) {
      const double next_t = length < 1 - t ? t + length : 1.0;
      At next = predicted(at, t, next_t - t);
      const double missed = corrected(next, next_t);
      const double grown = goal / missed;  // the error is of fifth order in the length
      if (!(missed <= most_missed)) {
        length = (next_t - t) / 2;
        continue;
      }
      at = next;
      t = next_t;
      if (t >= 1) {
        return true;
      }
      length *= (std::min)(2.0, std::pow(grown, 0.2));
    }
    return false;
  }

 private:
  // The length of Newton's first step after a prediction, in radians and relative to the size: the
  // error after the second step is about its fourth power.
  static constexpr double goal = 1e-3, most_missed = 1e-2;

  /// dz/dt = -(dH/dz)^-1 (g - turn f).
  [[nodiscard]] Step rate(const At& at, double t) const {
    const Step by_t = closures_at(to_, at) - turn_ * closures_at(from_, at);
    return -solved<Of>(jacobian(at, t), by_t);
  }
  [[nodiscard]] typename Of::ComplexSquare jacobian(const At& at, double t) const {
    return turn_ * (1 - t) * jacobian_at(from_, at) + t * jacobian_at(to_, at);
  }
  [[nodiscard]] Step newton_step(const At& at, double t) const {
    const Step open = turn_ * (1 - t) * closures_at(from_, at) + t * closures_at(to_, at);
    return -solved<Of>(jacobian(at, t), open);
  }

  /// The Runge-Kutta step of order four.
  [[nodiscard]] At predicted(const At& at, double t, double length) const {
    const Step first = rate(at, t);
    const Step second = rate(stepped<Of>(at, length / 2 * first), t + length / 2);
    const Step third = rate(stepped<Of>(at, length / 2 * second), t + length / 2);
    const Step last = rate(stepped<Of>(at, length * third), t + length);
    return stepped<Of>(at, length / 6 * (first + 2 * second + 2 * third + last));
  }

  /// Two Newton steps. Returns the length of the first one; NaN unless the second one is much
  /// shorter, which shows convergence to the path (Kantorovich).
  [[nodiscard]] double corrected(At& at, double t) const {
    const Step first = newton_step(at, t);
    at = stepped<Of>(at, first);
    const Step second = newton_step(at, t);
    at = stepped<Of>(at, second);
    const double length = length_of(first, at);
    const double left = length_of(second, at);
    constexpr double rounding = 1e-11;
    return left <= (std::max)(length / 8, rounding) ? (std::max)(length, rounding)
                                                    : std::numeric_limits<double>::quiet_NaN();
  }

  /// The largest entry of a step, relative for displacements longer than the size.
  [[nodiscard]] static double length_of(const Step& step, const At& at) {
    double result = 0;
    const Eigen::Index angles = step.size() - at.s.size();
    for (Eigen::Index entry = 0; entry < step.size(); ++entry) {
      const double unit = entry < angles ? 1 : unit_of(at.s(entry - angles));
      const double length = std::abs(step(entry)) / unit;
      result = length <= result ? result : length;  // NaN counts as the largest
    }
    return result;
  }

  const LoopEquations<Of>& from_;
  const LoopEquations<Of>& to_;
  Complex turn_;
};

/// Calls `visit(configuration)` for approximate complex configurations: all those of a group in
/// general position, and some spurious ones if there are fewer.
template <typename Of, typename Visit>
void each_candidate(const LoopEquations<Of>& equations, const Start& start, const Visit& visit) {
  const Eigen::Index angles = equations.of_angles.cols();
  const Eigen::Index slides = equations.slide_count();
  LoopEquations<Of> from = equations;
  std::copy_n(start.of_angles, from.of_angles.size(), from.of_angles.data());
  std::copy_n(start.of_slides, from.of_slides.size(), from.of_slides.data());
  const ParameterPath<Of> path(from, equations, start.turn);
  ComplexConfiguration<Of> at;
  at.theta.resize(angles);
  at.s.resize(slides);
  for (Eigen::Index one = 0; one < start.configurations; ++one) {
    std::copy_n(start.theta + one * angles, angles, at.theta.data());
    std::copy_n(start.s + one * slides, slides, at.s.data());
    (void)path.follow(at);
    if (at.theta.allFinite() && at.s.allFinite()) {
      visit(at);
    }
  }
}

}  // namespace assur::loops
