// Dual numbers: arithmetic on numbers with a derivative.
#pragma once

#include <type_traits>

namespace assur::numeric {

/// A number and its derivative along one direction.
template <typename Scalar>
struct Slope {
  Scalar value = 0;
  Scalar slope = 0;

  constexpr Slope() = default;
  constexpr explicit Slope(Scalar number, Scalar along = 0) : value(number), slope(along) {}

  /// A constant of generated code.
  template <
      typename Number,
      std::enable_if_t<std::is_same_v<Number, double> && !std::is_same_v<Scalar, double>, int> = 0>
  constexpr explicit Slope(Number number) : value(static_cast<Scalar>(number)) {}

  friend constexpr Slope operator-(Slope a) { return Slope(-a.value, -a.slope); }
  friend constexpr Slope operator+(Slope a, Slope b) {
    return Slope(a.value + b.value, a.slope + b.slope);
  }
  friend constexpr Slope operator-(Slope a, Slope b) {
    return Slope(a.value - b.value, a.slope - b.slope);
  }
  friend constexpr Slope operator*(Slope a, Slope b) {
    return Slope(a.value * b.value, a.slope * b.value + a.value * b.slope);
  }
};

}  // namespace assur::numeric
