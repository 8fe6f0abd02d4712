// Checks that the arithmetic of compiler and processor satisfies the assumptions of the error
// bounds.
#pragma once

#include <assur/numeric/double_double.hpp>
#include <limits>

namespace assur::numeric {

/// Whether the compiler promises to round every sum, product and quotient once, as written, and to
/// half an ulp of the scalar, double or float. Error bounds are derived from that. If float is
/// computed in double, it is rounded twice.
template <typename Scalar>
inline constexpr bool rounds_as_written = std::numeric_limits<Scalar>::is_iec559 &&
                                          (std::numeric_limits<Scalar>::digits == 53
#if !defined(__FLT_EVAL_METHOD__) || __FLT_EVAL_METHOD__ != 1
                                           || std::numeric_limits<Scalar>::digits == 24
#endif
                                          );

/// Whether error-free sums and products are exact. Not every compiler reports what it rearranges,
/// and none reports the rounding mode, so some are computed here, at run time.
template <typename Scalar>
[[nodiscard]] bool sums_are_exact() {
  constexpr int digits = std::numeric_limits<Scalar>::digits;
  constexpr auto power = [](int exponent) { return power_of_two<Scalar>(exponent); };
  const volatile Scalar unknown = 1;
  const Scalar one = unknown;
  // Rounding twice or towards zero gives the first of these a wrong sum, rounding upwards the
  // second.
  constexpr Scalar ulp = power(1 - digits);
  constexpr Scalar above_half = ulp / 2 + power(-digits - digits / 3);
  constexpr Scalar below_half = ulp / 4;
  const DoubleWord<Scalar> up = two_sum<Scalar>(one, above_half);
  const DoubleWord<Scalar> down = two_sum<Scalar>(one, below_half);
  constexpr Scalar little = power(-digits / 2 - 4);
  const DoubleWord<Scalar> square = two_prod<Scalar>(one + little, one + little);
  return (up.high == 1 + ulp) & (up.low == above_half - ulp) & (down.high == 1) &
         (down.low == below_half) & (square.high == 1 + 2 * little) &
         (square.low == little * little);
}

/// Whether subnormal numbers differ from zero.
template <typename Scalar>
[[nodiscard]] bool keeps_subnormals() {
  const volatile Scalar least = (std::numeric_limits<Scalar>::min)();
  return least / 2 > 0;
}

}  // namespace assur::numeric
