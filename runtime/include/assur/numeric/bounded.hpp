// Arithmetic with a running bound on the rounding error.
#pragma once

#include <assur/numeric/double_double.hpp>
#include <cmath>
#include <limits>
#include <type_traits>

namespace assur::numeric {

/// `value` differs from the exact result of the same operations on the same inputs by at most
/// `bound`. Inputs are exact. Bounds have the precision of the scalar, for a double word that of
/// its parts, and are themselves rounded; `certain_bound` allows for that.
template <typename Scalar>
struct Bounded {
  using Bound = typename PartOf<Scalar>::Type;
  Scalar value{0};
  Bound bound = 0;

  Bounded() = default;
  Bounded(Scalar exact) : value(exact) {}
  Bounded(int exact) : value(static_cast<Scalar>(exact)) {}
  /// A constant of generated code, rounded if the scalar has fewer digits than double.
  template <
      typename Number,
      std::enable_if_t<std::is_same_v<Number, double> && !std::is_same_v<Scalar, double>, int> = 0>
  Bounded(Number exact) : value(static_cast<Scalar>(exact)) {
    if constexpr (!std::is_same_v<Bound, double>) {
      bound = unit() * size();
    }
  }
  Bounded(Scalar middle, Bound within) : value(middle), bound(within) {}

  /// Half of epsilon: the largest relative error of one operation.
  static constexpr Bound unit() {
    return static_cast<Bound>(std::numeric_limits<Scalar>::epsilon()) / 2;
  }
  [[nodiscard]] Bound size() const { return std::abs(static_cast<Bound>(value)); }
  /// Larger than the true bound, for up to a thousand operations one after the other.
  [[nodiscard]] Bound certain_bound() const {
    constexpr Bound larger = 1 + power_of_two<Bound>(12) * std::numeric_limits<Bound>::epsilon();
    return bound * larger;
  }
  /// Whether the sign of the exact number is known.
  [[nodiscard]] bool sign_is_certain() const { return size() > certain_bound(); }

  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    const Scalar sum = a.value + b.value;
    return {sum, a.bound + b.bound + unit() * std::abs(static_cast<Bound>(sum))};
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) {
    const Scalar difference = a.value - b.value;
    return {difference, a.bound + b.bound + unit() * std::abs(static_cast<Bound>(difference))};
  }
  friend Bounded operator-(const Bounded& a) { return {-a.value, a.bound}; }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    const Scalar product = a.value * b.value;
    return {product, (a.size() + a.bound) * b.bound + b.size() * a.bound +
                         unit() * std::abs(static_cast<Bound>(product))};
  }
  /// Only constants of generated code are divisors, and these are exact in double.
  friend Bounded operator/(const Bounded& a, const Bounded& b) {
    const Scalar quotient = a.value / b.value;
    const Bound size = std::abs(static_cast<Bound>(quotient));
    if constexpr (!std::is_same_v<Bound, double>) {
      return {quotient, (a.bound + size * b.bound) / (b.size() - b.bound) + unit() * size};
    }
    return {quotient, a.bound / b.size() + unit() * size};
  }
};

}  // namespace assur::numeric
