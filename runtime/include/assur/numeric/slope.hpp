// Turns sums and products of numbers into those of numbers with a derivative.
#pragma once

namespace assur::numeric {

/// A number and its derivative along one direction.
struct Slope {
  double value = 0;
  double slope = 0;

  constexpr Slope() = default;
  constexpr explicit Slope(double number, double along = 0) : value(number), slope(along) {}

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
