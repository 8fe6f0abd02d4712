// Partial derivatives of a power with respect to base and exponent.
#pragma once

#include <cmath>
#include <limits>

namespace assur::support {

/// The derivative of a^b, `ByBase` times with respect to a and `ByExponent` times with respect to
/// b, up to second order in all; NaN if it does not exist. A negative base has powers for integer
/// exponents only, and so no derivative with respect to the exponent; neither has a base of zero if
/// the powers on the two sides of the exponent differ.
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
