// Arithmetic on magnitudes: size and rounding error of results for all operands of bounded size.
#pragma once

#include <cmath>
#include <limits>

namespace assur::numeric {

/// Numbers of absolute value at most `size` with a rounding error of at most `units` times half an
/// epsilon. Results hold for all numbers that are no larger.
struct Magnitude {
  double size = 0;
  double units = 0;

  Magnitude() = default;
  /// A number in generated code, which may have been rounded.
  explicit Magnitude(double number) : size(std::abs(number)), units(std::abs(number)) {}
  explicit Magnitude(int number) : size(std::abs(number)) {}
  Magnitude(double most, double error) : size(most), units(error) {}

  /// A zero with an error.
  static Magnitude error(double most) {
    return {0, most / (std::numeric_limits<double>::epsilon() / 2)};
  }
  static constexpr double given_units = 4;
  /// A variable with an error of a few roundings of its size.
  static Magnitude given(double most) { return {most, given_units * most}; }
  static constexpr double given_rounding() {
    return given_units * std::numeric_limits<double>::epsilon() / 2;
  }

  /// The largest error, with an eighth added for the rounding of this estimate and higher orders.
  [[nodiscard]] double rounding() const {
    return units * (std::numeric_limits<double>::epsilon() / 2) * 1.125;
  }

  friend Magnitude operator+(const Magnitude& a, const Magnitude& b) {
    return {a.size + b.size, a.units + b.units + a.size + b.size};
  }
  friend Magnitude operator-(const Magnitude& a, const Magnitude& b) { return a + b; }
  friend Magnitude operator-(const Magnitude& a) { return a; }
  friend Magnitude operator*(const Magnitude& a, const Magnitude& b) {
    return {a.size * b.size, a.size * b.units + a.units * b.size + a.size * b.size};
  }
  /// Only constants of generated code are divisors; any other divisor has no lower bound.
  friend Magnitude operator/(const Magnitude& a, const Magnitude& b) {
    if (b.units > b.size) {
      constexpr double none = std::numeric_limits<double>::infinity();
      return {none, none};
    }
    return {a.size / b.size, (a.units + a.size) / b.size};
  }
  friend Magnitude abs(const Magnitude& a) { return a; }
};

}  // namespace assur::numeric
