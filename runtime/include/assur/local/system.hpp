// Systems of constraints that depend on one parameter, and their derivatives by finite differences.
#pragma once

#include <assur/model.hpp>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

namespace assur::local {

// A `System` is a set of constraints F(z) = 0, z = (q, s), with coordinates q and path parameter s.
// Lengths are divided by the mechanism's size; a unit of s moves the mechanism by its size. It has
//
//   using Scalar, Point;
//   static constexpr int rows, unknowns;  // unknowns without s; or Eigen::Dynamic
//   int row_count() const;                // their numbers
//   int unknown_count() const;
//   static constexpr int most_corank;     // the greatest one sought; needed if sizes are fixed
//   Vector<Scalar, rows> misses(const Point&) const;                    // F(z)
//   void move(const Vector<Scalar, unknowns + 1>& step, Point&) const;  // the last entry along s
//
// and may have F' and F''(., v), which are otherwise computed by finite differences:
//
//   Matrix<Scalar, rows, unknowns + 1> jacobian(const Point&) const;
//   Matrix<Scalar, rows, unknowns + 1> bends(const Point&, const Step& v) const;

template <typename System>
inline constexpr bool has_fixed_size = System::rows != Eigen::Dynamic;
template <typename System>
inline constexpr int columns_of = has_fixed_size<System> ? System::unknowns + 1 : Eigen::Dynamic;
template <typename System>
using OpenOf = Vector<typename System::Scalar, System::rows>;
template <typename System>
using StepOf = Vector<typename System::Scalar, columns_of<System>>;
template <typename System>
using WideOf = Matrix<typename System::Scalar, System::rows, columns_of<System>>;

/// F at a point moved by a step.
template <typename System>
[[nodiscard]] OpenOf<System> misses_beside(const System& system, typename System::Point point,
                                           const StepOf<System>& step) {
  system.move(step, point);
  return system.misses(point);
}

template <typename System, typename = void>
inline constexpr bool has_jacobian = false;
template <typename System>
inline constexpr bool
    has_jacobian<System, std::void_t<decltype(std::declval<const System&>().jacobian(
                             std::declval<const typename System::Point&>()))>> = true;

/// F', or its central difference, whose error is about epsilon^(2/3).
template <typename System>
[[nodiscard]] WideOf<System> jacobian(const System& system, const typename System::Point& point) {
  if constexpr (has_jacobian<System>) {
    return system.jacobian(point);
  } else {
    using Scalar = typename System::Scalar;
    const Scalar width = std::cbrt(std::numeric_limits<Scalar>::epsilon());
    const int columns = system.unknown_count() + 1;
    WideOf<System> J(system.row_count(), columns);
    for (int column = 0; column < columns; ++column) {
      const StepOf<System> step = width * StepOf<System>::Unit(columns, column);
      J.col(column) =
          (misses_beside(system, point, step) - misses_beside<System>(system, point, -step)) /
          (2 * width);
    }
    return J;
  }
}

/// F''(., v), or its central difference, whose error is about epsilon^(1/2).
template <typename System>
[[nodiscard]] WideOf<System> bends(const System& system, const typename System::Point& point,
                                   const StepOf<System>& v) {
  if constexpr (has_jacobian<System>) {
    return system.bends(point, v);
  } else {
    using Scalar = typename System::Scalar;
    const Scalar width = std::sqrt(std::sqrt(std::numeric_limits<Scalar>::epsilon()));
    const int columns = system.unknown_count() + 1;
    WideOf<System> result(system.row_count(), columns);
    for (int column = 0; column < columns; ++column) {
      const StepOf<System> unit = StepOf<System>::Unit(columns, column);
      const StepOf<System> sum = width * (unit + v);
      const StepOf<System> difference = width * (unit - v);
      result.col(column) =
          (misses_beside(system, point, sum) + misses_beside<System>(system, point, -sum) -
           misses_beside(system, point, difference) -
           misses_beside<System>(system, point, -difference)) /
          (4 * width * width);
    }
    return result;
  }
}

}  // namespace assur::local
