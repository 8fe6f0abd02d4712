// Moves and examines a model's variables by index: angles turn, lengths shift.
#pragma once

#include <algorithm>
#include <assur/model.hpp>
#include <cmath>
#include <tuple>

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

/// The direction scaled back to the unit circle, to first order: for pairs that rounding moved.
template <typename Scalar>
[[nodiscard]] constexpr Direction<Scalar> normalised(const Direction<Scalar>& direction) {
  const Scalar square = direction.cos * direction.cos + direction.sin * direction.sin;
  const Scalar scale = (Scalar(3) - square) / Scalar(2);
  return {direction.cos * scale, direction.sin * scale};
}

namespace detail {

template <typename Scalar>
void advance_member(Scalar& length, const Scalar& step) {
  length = length + step;
}
template <typename Scalar>
void advance_member(Direction<Scalar>& direction, const Scalar& step) {
  direction = normalised(turned(direction, direction_of(step)));
}

template <typename Scalar>
[[nodiscard]] bool is_finite_member(const Scalar& length) {
  using std::isfinite;
  return isfinite(length);
}
template <typename Scalar>
[[nodiscard]] bool is_finite_member(const Direction<Scalar>& direction) {
  return is_finite_member(direction.cos) && is_finite_member(direction.sin);
}

}  // namespace detail

/// Adds a step to every variable: lengths grow, angles turn. `Variables` is a model's Dimensions,
/// Inputs or Configuration; the step has their order.
template <typename Variables, typename Scalar, int Count>
void advance(Variables& variables, const Vector<Scalar, Count>& step) {
  std::apply(
      [&step](auto&... member) {
        Eigen::Index index = 0;
        (detail::advance_member(member, step(index++)), ...);
      },
      variables.members());
}

/// The largest of the lengths and coordinates among variables, by magnitude; zero if there is none.
template <typename Variables>
[[nodiscard]] double longest_length(const Variables& variables) {
  double largest = 0;
  const auto measure = [&largest](const auto& member) {
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
      largest = std::max(largest, std::abs(member));
    }
  };
  std::apply([&](const auto&... member) { (measure(member), ...); }, variables.members());
  return largest;
}

/// Whether no entry is NaN or infinite.
template <typename Scalar, int Count>
[[nodiscard]] bool is_finite(const Vector<Scalar, Count>& vector) {
  for (int index = 0; index < Count; ++index) {
    if (!detail::is_finite_member(vector(index))) {
      return false;
    }
  }
  return true;
}

/// Whether no variable is NaN or infinite.
template <typename Variables>
[[nodiscard]] bool is_finite(const Variables& variables) {
  return std::apply([](const auto&... member) { return (detail::is_finite_member(member) && ...); },
                    variables.members());
}

}  // namespace assur
