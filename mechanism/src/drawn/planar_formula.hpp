// Plane vectors of formulas: rotation, length and angle.
#pragma once

#include <assur/mechanism/formula.hpp>

namespace assur::mechanism::drawn {

/// A vector in the plane.
struct Vector {
  Formula x, y;
};

[[nodiscard]] inline Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y};
}
[[nodiscard]] inline Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y};
}
[[nodiscard]] inline Vector operator*(const Formula& factor, const Vector& a) {
  return {factor * a.x, factor * a.y};
}

[[nodiscard]] inline Formula root(const Formula& a) {
  return Formula::of(text::Operation::sqrt, a);
}
[[nodiscard]] inline Formula negative(const Formula& a) {
  return Formula::of(text::Operation::negate, a);
}
[[nodiscard]] inline Formula length(const Vector& a) { return root(a.x * a.x + a.y * a.y); }
/// The angle from the x-axis, in (-pi, pi].
[[nodiscard]] inline Formula angle(const Vector& a) {
  return Formula::of(text::Operation::atan2, a.y, a.x);
}
/// A vector of a frame whose x-axis is the unit vector `axis`, in the frame of the drawing.
[[nodiscard]] inline Vector turned(const Vector& a, const Vector& axis) {
  return {axis.x * a.x - axis.y * a.y, axis.y * a.x + axis.x * a.y};
}
/// A vector of the drawing, in a frame whose x-axis is the unit vector `axis`.
[[nodiscard]] inline Vector turned_back(const Vector& a, const Vector& axis) {
  return {axis.x * a.x + axis.y * a.y, axis.x * a.y - axis.y * a.x};
}

}  // namespace assur::mechanism::drawn
