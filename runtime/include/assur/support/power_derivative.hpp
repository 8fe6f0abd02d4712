// Turns a base and an exponent into the derivatives of the power by both.
#pragma once

#include <cmath>
#include <limits>

namespace assur::support {

/// The derivative of a^b, `ByBase` times by a and `ByExponent` times by b, to the second order; NaN
/// where there is none. A negative base has powers for whole exponents alone, and so no derivative
/// by the exponent; nor has zero where its powers on either side of the exponent differ.
template <int ByBase, int ByExponent, typename Scalar>
[[nodiscard]] Scalar power_derivative(const Scalar& a, const Scalar& b) {
  static_assert(ByBase + ByExponent <= 2, "derivatives of higher orders are not known here");
  using std::log;
  using std::pow;
  if constexpr (ByExponent == 0) {
    const Scalar factor = ByBase == 0 ? Scalar(1) : ByBase == 1 ? b : b * (b - 1);
    return factor == 0 ? Scalar(0) : factor * pow(a, b - ByBase);
  } else {
    if (a == 0 && b > ByBase) {
      return Scalar(0);
    }
    if (!(a > 0)) {
      return std::numeric_limits<Scalar>::quiet_NaN();
    }
    const Scalar logarithm = log(a);
    const Scalar factor = ByBase == 1       ? 1 + b * logarithm
                          : ByExponent == 1 ? logarithm
                                            : logarithm * logarithm;
    return factor * pow(a, b - ByBase);
  }
}

}  // namespace assur::support
