// Arithmetic on numbers that depend on time and on one parameter.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace assur::mechanism::forces {

/// A number x(t, a) about t = 0 and the value of a parameter a: its Taylor coefficients up to t^2,
/// and the derivative of each of them with respect to a.
class MovingNumber {
 public:
  MovingNumber() = default;
  explicit MovingNumber(double constant) : at_{constant, 0, 0} {}
  MovingNumber(double value, double rate, double second_rate) : at_{value, rate, second_rate / 2} {}
  /// The coefficients of 1, t and t^2, and their derivatives.
  using Coefficients = std::array<double, 3>;
  MovingNumber(const Coefficients& at, const Coefficients& by) : at_(at), by_(by) {}

  [[nodiscard]] double value() const { return at_[0]; }
  [[nodiscard]] double rate() const { return at_[1]; }
  [[nodiscard]] double second_rate() const { return 2 * at_[2]; }
  /// The derivative of the value with respect to the parameter.
  [[nodiscard]] double derivative() const { return by_[0]; }
  [[nodiscard]] const Coefficients& at() const { return at_; }
  [[nodiscard]] const Coefficients& by() const { return by_; }

  /// Whether the value, or its derivative, is not zero.
  [[nodiscard]] bool matters() const { return at_[0] != 0 || by_[0] != 0; }
  /// The value with its derivative with respect to the parameter, at rest.
  [[nodiscard]] MovingNumber at_rest() const { return {{at_[0], 0, 0}, {by_[0], 0, 0}}; }
  /// The number with another rate, or another second rate, each with its derivative.
  [[nodiscard]] MovingNumber with_rate(const MovingNumber& rate) const {
    return {{at_[0], rate.at_[0], at_[2]}, {by_[0], rate.by_[0], by_[2]}};
  }
  [[nodiscard]] MovingNumber with_second_rate(const MovingNumber& second) const {
    return {{at_[0], at_[1], second.at_[0] / 2}, {by_[0], by_[1], second.by_[0] / 2}};
  }

  /// The rate and the second rate, as numbers at rest.
  [[nodiscard]] MovingNumber its_rate() const { return {{at_[1], 0, 0}, {by_[1], 0, 0}}; }
  [[nodiscard]] MovingNumber its_second_rate() const {
    return {{2 * at_[2], 0, 0}, {2 * by_[2], 0, 0}};
  }

  /// The variation of the number with t and a: the number minus its value.
  [[nodiscard]] MovingNumber variation() const { return {{0, at_[1], at_[2]}, by_}; }

  /// The same number with another value.
  [[nodiscard]] MovingNumber valued(double value) const { return {{value, at_[1], at_[2]}, by_}; }

  /// A function of the number, by its value and its first three derivatives there: all products of
  /// more than three variations vanish. A derivative that does not exist matters only if the number
  /// varies.
  [[nodiscard]] MovingNumber through(double f, double first, double second, double third) const {
    MovingNumber result(f);
    const MovingNumber once = variation();
    const MovingNumber twice = once * once;
    result.add(first, once);
    result.add(second / 2, twice);
    result.add(third / 6, twice * once);
    return result;
  }

  friend MovingNumber operator+(const MovingNumber& a, const MovingNumber& b) {
    MovingNumber sum = a;
    for (std::size_t k = 0; k < 3; ++k) {
      sum.at_[k] += b.at_[k];
      sum.by_[k] += b.by_[k];
    }
    return sum;
  }
  friend MovingNumber operator-(const MovingNumber& a) { return MovingNumber(-1.0) * a; }
  friend MovingNumber operator-(const MovingNumber& a, const MovingNumber& b) { return a + -b; }
  friend MovingNumber operator*(const MovingNumber& a, const MovingNumber& b) {
    MovingNumber product;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i <= k; ++i) {
        product.at_[k] += a.at_[i] * b.at_[k - i];
        product.by_[k] += a.by_[i] * b.at_[k - i] + a.at_[i] * b.by_[k - i];
      }
    }
    return product;
  }

 private:
  void add(double factor, const MovingNumber& term) {
    for (std::size_t k = 0; k < 3; ++k) {
      at_[k] += term.at_[k] == 0 ? 0 : factor * term.at_[k];
      by_[k] += term.by_[k] == 0 ? 0 : factor * term.by_[k];
    }
  }

  Coefficients at_{}, by_{};
};

inline MovingNumber operator/(const MovingNumber& a, const MovingNumber& b) {
  const double inverse = 1 / b.value();
  const double square = inverse * inverse;
  return a * b.through(inverse, -square, 2 * inverse * square, -6 * square * square);
}
inline MovingNumber operator*(double a, const MovingNumber& b) { return MovingNumber(a) * b; }
inline MovingNumber operator/(const MovingNumber& a, double b) { return a / MovingNumber(b); }

inline MovingNumber sqrt(const MovingNumber& a) {
  const double root = std::sqrt(a.value());
  const double cube = root * a.value();
  return a.through(root, 0.5 / root, -0.25 / cube, 0.375 / (cube * a.value()));
}
inline MovingNumber sin(const MovingNumber& a) {
  const double s = std::sin(a.value());
  const double c = std::cos(a.value());
  return a.through(s, c, -s, -c);
}
inline MovingNumber cos(const MovingNumber& a) {
  const double s = std::sin(a.value());
  const double c = std::cos(a.value());
  return a.through(c, -s, -c, s);
}
inline MovingNumber tan(const MovingNumber& a) { return sin(a) / cos(a); }
inline MovingNumber asin(const MovingNumber& a) {
  const double x = a.value();
  const double slope = 1 / std::sqrt((1 - x) * (1 + x));
  const double cube = slope * slope * slope;
  return a.through(std::asin(x), slope, x * cube, (1 + 2 * x * x) * cube * slope * slope);
}
inline MovingNumber acos(const MovingNumber& a) {
  return MovingNumber(std::numbers::pi / 2) - asin(a);
}
inline MovingNumber atan(const MovingNumber& a) {
  const double x = a.value();
  const double slope = 1 / (1 + x * x);
  return a.through(std::atan(x), slope, -2 * x * slope * slope,
                   (6 * x * x - 2) * slope * slope * slope);
}
/// The angle of (x, y): that of its value, plus the turn of (x, y) from there.
inline MovingNumber atan2(const MovingNumber& y, const MovingNumber& x) {
  const MovingNumber across = x.value() * y - y.value() * x;
  const MovingNumber along = x.value() * x + y.value() * y;
  return atan(across / along).valued(std::atan2(y.value(), x.value()));
}
/// At a corner the derivatives are those of `Dual`.
inline MovingNumber abs(const MovingNumber& a) { return a.value() < 0 ? -a : a; }
inline MovingNumber min(const MovingNumber& a, const MovingNumber& b) {
  return b.value() < a.value() ? b : a;
}
inline MovingNumber max(const MovingNumber& a, const MovingNumber& b) {
  return a.value() < b.value() ? b : a;
}
inline MovingNumber pow(const MovingNumber& a, double n) {
  const double x = a.value();
  const auto derivative = [x, n](double factor, double order) {
    return factor == 0 ? 0 : factor * std::pow(x, n - order);
  };
  return a.through(std::pow(x, n), derivative(n, 1), derivative(n * (n - 1), 2),
                   derivative(n * (n - 1) * (n - 2), 3));
}
/// A power with a variable exponent has derivatives for a positive base alone.
inline MovingNumber pow(const MovingNumber& a, const MovingNumber& b) {
  const auto is_zero = [](const MovingNumber::Coefficients& c) {
    return c == MovingNumber::Coefficients{};
  };
  if (is_zero(b.variation().at()) && is_zero(b.by())) {
    return pow(a, b.value());
  }
  const double x = a.value();
  const double power = std::pow(x, b.value());
  if (!(x > 0)) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return b.through(power, none, none, none) + a.through(0, none, none, none);
  }
  const MovingNumber logarithm = a.through(std::log(x), 1 / x, -1 / (x * x), 2 / (x * x * x));
  const MovingNumber exponent = b * logarithm;
  return exponent.through(power, power, power, power);
}

}  // namespace assur::mechanism::forces
