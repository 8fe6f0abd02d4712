// Numbers with their first two time derivatives.
#pragma once

#include <cmath>

namespace assur::test {

/// A number that moves: its value, rate and second rate.
struct Jet {
  double value = 0;
  double rate = 0;
  double second = 0;

  Jet() = default;
  Jet(double given) : value(given) {}  // NOLINT(google-explicit-constructor): as numbers convert
  Jet(double given, double first, double next) : value(given), rate(first), second(next) {}

  /// A function of this number, by its value and its first two derivatives there.
  [[nodiscard]] Jet through(double f, double first, double next) const {
    return {f, first * rate, first * second + next * rate * rate};
  }
};

inline Jet operator+(const Jet& a, const Jet& b) {
  return {a.value + b.value, a.rate + b.rate, a.second + b.second};
}
inline Jet operator-(const Jet& a, const Jet& b) {
  return {a.value - b.value, a.rate - b.rate, a.second - b.second};
}
inline Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.rate * b.value + a.value * b.rate,
          a.second * b.value + 2 * a.rate * b.rate + a.value * b.second};
}
inline Jet operator/(const Jet& a, const Jet& b) {
  const double inverse = 1 / b.value;
  return a * b.through(inverse, -inverse * inverse, 2 * inverse * inverse * inverse);
}
inline Jet sqrt(const Jet& a) {
  const double root = std::sqrt(a.value);
  return a.through(root, 0.5 / root, -0.25 / (root * a.value));
}
inline Jet sin(const Jet& a) {
  return a.through(std::sin(a.value), std::cos(a.value), -std::sin(a.value));
}
inline Jet cos(const Jet& a) {
  return a.through(std::cos(a.value), -std::sin(a.value), -std::cos(a.value));
}

/// A point that moves.
struct JetPoint {
  Jet x, y;

  [[nodiscard]] JetPoint turned() const { return {Jet(0) - y, x}; }  ///< by 90 degrees
};

inline JetPoint operator+(const JetPoint& a, const JetPoint& b) { return {a.x + b.x, a.y + b.y}; }
inline JetPoint operator-(const JetPoint& a, const JetPoint& b) { return {a.x - b.x, a.y - b.y}; }
inline JetPoint operator*(const Jet& factor, const JetPoint& a) {
  return {factor * a.x, factor * a.y};
}
inline Jet dot(const JetPoint& a, const JetPoint& b) { return a.x * b.x + a.y * b.y; }

/// The vector (x, y) of a link that stands at an angle.
inline JetPoint at_angle(const Jet& angle, double x, double y = 0) {
  const JetPoint axis{cos(angle), sin(angle)};
  return Jet(x) * axis + Jet(y) * axis.turned();
}

}  // namespace assur::test
