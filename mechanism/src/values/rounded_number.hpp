// Values of expressions with bounds on their rounding errors.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace assur::mechanism::values {

/// A number, and a first-order bound on its rounding error as the value of an expression. Numbers
/// in the text count as exact: the bound serves for terms that cancel, as in 1 + cos(180*deg).
struct RoundedNumber {
  double value = 0;
  double error = 0;

  RoundedNumber(double number = 0) : value(number) {}
  RoundedNumber(double number, double within) : value(number), error(within) {}
};

/// The rounded result of an operation on numbers that contribute an `error` to it.
[[nodiscard]] inline RoundedNumber rounded_to(double value, double error) {
  return {value, error + std::numeric_limits<double>::epsilon() * std::abs(value)};
}

[[nodiscard]] inline RoundedNumber operator-(const RoundedNumber& a) { return {-a.value, a.error}; }
[[nodiscard]] inline RoundedNumber operator+(const RoundedNumber& a, const RoundedNumber& b) {
  return rounded_to(a.value + b.value, a.error + b.error);
}
[[nodiscard]] inline RoundedNumber operator-(const RoundedNumber& a, const RoundedNumber& b) {
  return rounded_to(a.value - b.value, a.error + b.error);
}
[[nodiscard]] inline RoundedNumber operator*(const RoundedNumber& a, const RoundedNumber& b) {
  return rounded_to(a.value * b.value, std::abs(a.value) * b.error + std::abs(b.value) * a.error);
}
[[nodiscard]] inline RoundedNumber operator/(const RoundedNumber& a, const RoundedNumber& b) {
  const double quotient = a.value / b.value;
  return rounded_to(quotient, (a.error + std::abs(quotient) * b.error) / std::abs(b.value));
}
[[nodiscard]] inline RoundedNumber sin(const RoundedNumber& a) {
  return rounded_to(std::sin(a.value), std::abs(std::cos(a.value)) * a.error);
}
[[nodiscard]] inline RoundedNumber cos(const RoundedNumber& a) {
  return rounded_to(std::cos(a.value), std::abs(std::sin(a.value)) * a.error);
}
[[nodiscard]] inline RoundedNumber tan(const RoundedNumber& a) {
  const double value = std::tan(a.value);
  return rounded_to(value, (1 + value * value) * a.error);
}
/// A bound on the slope of a square root. Near zero, the error of the argument may exceed its
/// value.
[[nodiscard]] inline double root_slope(double inside, double error) {
  return 1 / std::sqrt(std::max({inside, error, std::numeric_limits<double>::min()}));
}
[[nodiscard]] inline RoundedNumber sqrt(const RoundedNumber& a) {
  return rounded_to(std::sqrt(a.value), root_slope(a.value, a.error) * a.error);
}
[[nodiscard]] inline RoundedNumber asin(const RoundedNumber& a) {
  return rounded_to(std::asin(a.value), root_slope(1 - a.value * a.value, a.error) * a.error);
}
[[nodiscard]] inline RoundedNumber acos(const RoundedNumber& a) {
  return rounded_to(std::acos(a.value), root_slope(1 - a.value * a.value, a.error) * a.error);
}
[[nodiscard]] inline RoundedNumber atan(const RoundedNumber& a) {
  return rounded_to(std::atan(a.value), a.error / (1 + a.value * a.value));
}
[[nodiscard]] inline RoundedNumber atan2(const RoundedNumber& y, const RoundedNumber& x) {
  const double length = std::hypot(x.value, y.value);
  return rounded_to(std::atan2(y.value, x.value), (x.error + y.error) / length);
}
[[nodiscard]] inline RoundedNumber abs(const RoundedNumber& a) {
  return {std::abs(a.value), a.error};
}
/// If the two are that near, rounding may select the wrong one.
[[nodiscard]] inline RoundedNumber min(const RoundedNumber& a, const RoundedNumber& b) {
  return {std::min(a.value, b.value), std::max(a.error, b.error)};
}
[[nodiscard]] inline RoundedNumber max(const RoundedNumber& a, const RoundedNumber& b) {
  return {std::max(a.value, b.value), std::max(a.error, b.error)};
}
[[nodiscard]] inline RoundedNumber pow(const RoundedNumber& a, double exponent) {
  const double value = std::pow(a.value, exponent);
  return rounded_to(value, std::abs(exponent * std::pow(a.value, exponent - 1)) * a.error);
}
[[nodiscard]] inline RoundedNumber pow(const RoundedNumber& a, const RoundedNumber& b) {
  const RoundedNumber power = pow(a, b.value);
  return b.error > 0 && power.value != 0
             ? RoundedNumber(
                   power.value,
                   power.error + std::abs(power.value * std::log(std::abs(a.value))) * b.error)
             : power;
}

}  // namespace assur::mechanism::values
