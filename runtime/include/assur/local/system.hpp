// Constraints that move with one parameter, and their derivatives by differences.
#pragma once

#include <assur/model.hpp>
#include <cmath>
#include <limits>

namespace assur::local {

// A `System` is a set of constraints F(z) = 0, z = (q, s): places q, and the way s along which they
// move. Lengths are in parts of the size, and s is in parts of the way that moves the mechanism by
// its size. It has
//
//   using Scalar, Point;
//   static constexpr int rows, unknowns, most_corank;  // unknowns without s
//   Vector<Scalar, rows> misses(const Point&) const;                   // F(z)
//   void move(const Vector<Scalar, unknowns + 1>& step, Point&) const; // the last entry along s
//   Scalar rounding(const Point&) const;                               // what rounding leaves of F

template <typename System>
using OpenOf = Vector<typename System::Scalar, System::rows>;
template <typename System>
using StepOf = Vector<typename System::Scalar, System::unknowns + 1>;
template <typename System>
using WideOf = Matrix<typename System::Scalar, System::rows, System::unknowns + 1>;

/// F where a point has moved by a step.
template <typename System>
[[nodiscard]] OpenOf<System> misses_beside(const System& system, typename System::Point point,
                                           const StepOf<System>& step) {
  system.move(step, point);
  return system.misses(point);
}

/// F' by central differences, to about the square of the cube root of a rounding.
template <typename System>
[[nodiscard]] WideOf<System> jacobian(const System& system, const typename System::Point& point) {
  using Scalar = typename System::Scalar;
  const Scalar width = std::cbrt(std::numeric_limits<Scalar>::epsilon());
  WideOf<System> J;
  for (int column = 0; column <= System::unknowns; ++column) {
    const StepOf<System> step = width * StepOf<System>::Unit(column);
    J.col(column) =
        (misses_beside(system, point, step) - misses_beside<System>(system, point, -step)) /
        (2 * width);
  }
  return J;
}

/// F''(one, other) by central differences, to about the root of a rounding.
template <typename System>
[[nodiscard]] OpenOf<System> bend(const System& system, const typename System::Point& point,
                                  const StepOf<System>& one, const StepOf<System>& other) {
  using Scalar = typename System::Scalar;
  const Scalar width = std::sqrt(std::sqrt(std::numeric_limits<Scalar>::epsilon()));
  const StepOf<System> sum = width * (one + other);
  const StepOf<System> difference = width * (one - other);
  return (misses_beside(system, point, sum) + misses_beside<System>(system, point, -sum) -
          misses_beside(system, point, difference) -
          misses_beside<System>(system, point, -difference)) /
         (4 * width * width);
}

}  // namespace assur::local
