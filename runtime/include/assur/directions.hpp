// Angles as unit vectors (cos, sin), and their sums and differences.
//
// The functions are total: none of them divides, and an input that is not finite makes a result
// that is not finite.
#pragma once

#include <assur/model.hpp>
#include <cmath>

namespace assur {

/// The direction of an angle in radians.
template <typename Scalar>
[[nodiscard]] Direction<Scalar> direction_of(Scalar angle) {
  using std::cos;
  using std::sin;
  return {cos(angle), sin(angle)};
}

/// The angle of a direction in radians, in (-pi, pi].
template <typename Scalar>
[[nodiscard]] Scalar angle_of(const Direction<Scalar>& direction) {
  using std::atan2;
  return atan2(direction.sin, direction.cos);
}

/// The direction turned counter-clockwise by another: the sum of the two angles.
template <typename Scalar>
[[nodiscard]] constexpr Direction<Scalar> turned(const Direction<Scalar>& direction,
                                                 const Direction<Scalar>& by) {
  return {direction.cos * by.cos - direction.sin * by.sin,
          direction.sin * by.cos + direction.cos * by.sin};
}

/// The direction with the opposite angle.
template <typename Scalar>
[[nodiscard]] constexpr Direction<Scalar> reversed(const Direction<Scalar>& direction) {
  return {direction.cos, -direction.sin};
}

/// The direction scaled back to the unit circle, to first order, to remove rounding errors.
template <typename Scalar>
[[nodiscard]] constexpr Direction<Scalar> normalised(const Direction<Scalar>& direction) {
  const Scalar square = direction.cos * direction.cos + direction.sin * direction.sin;
  const Scalar scale = (Scalar(3) - square) / Scalar(2);
  return {direction.cos * scale, direction.sin * scale};
}

}  // namespace assur
