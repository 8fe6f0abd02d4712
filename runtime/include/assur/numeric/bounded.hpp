// Turns arithmetic into arithmetic with a bound of its rounding error, to certify a result.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

namespace assur::numeric {

/// `value` differs from the exact result of the same operations on the same inputs by at most
/// `bound`. Inputs are exact. Bounds are kept in double and are themselves rounded; `certain_bound`
/// adds what that may have lost.
template <typename Scalar>
struct Bounded {
  Scalar value{0};
  double bound = 0;

  Bounded() = default;
  Bounded(Scalar exact) : value(exact) {}
  Bounded(int exact) : value(exact) {}
  template <
      typename Number,
      std::enable_if_t<std::is_same_v<Number, double> && !std::is_same_v<Scalar, double>, int> = 0>
  Bounded(Number exact) : value(exact) {}
  Bounded(Scalar middle, double within) : value(middle), bound(within) {}

  /// Half of epsilon: the largest relative error of one operation.
  static constexpr double unit() {
    return static_cast<double>(std::numeric_limits<Scalar>::epsilon()) / 2;
  }
  [[nodiscard]] double size() const { return std::abs(static_cast<double>(value)); }
  /// Larger than the true bound, for up to a million operations.
  [[nodiscard]] double certain_bound() const { return bound * (1 + 1e-9); }
  /// Whether the sign of the exact number is known.
  [[nodiscard]] bool sign_is_certain() const { return size() > certain_bound(); }

  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    const Scalar sum = a.value + b.value;
    return {sum, a.bound + b.bound + unit() * std::abs(static_cast<double>(sum))};
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) {
    const Scalar difference = a.value - b.value;
    return {difference, a.bound + b.bound + unit() * std::abs(static_cast<double>(difference))};
  }
  friend Bounded operator-(const Bounded& a) { return {-a.value, a.bound}; }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    const Scalar product = a.value * b.value;
    return {product, (a.size() + a.bound) * b.bound + b.size() * a.bound +
                         unit() * std::abs(static_cast<double>(product))};
  }
  /// By an exact number only: the constants of generated code.
  friend Bounded operator/(const Bounded& a, const Bounded& b) {
    const Scalar quotient = a.value / b.value;
    return {quotient, a.bound / b.size() + unit() * std::abs(static_cast<double>(quotient))};
  }
};

}  // namespace assur::numeric
