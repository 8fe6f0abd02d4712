// Turns the arithmetic that a program was compiled with, and runs on, into whether bounds hold.
#pragma once

#include <assur/numeric/double_double.hpp>
#include <limits>

namespace assur::numeric {

/// Whether comparisons tell NaN and infinity from numbers, which -ffinite-math-only ends.
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
inline constexpr bool tells_nan = false;
#else
inline constexpr bool tells_nan = true;
#endif

/// Whether the compiler promises to round every sum, product and quotient once, where it is
/// written, and to half an ulp of double. Bounds of rounding are derived from that.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FLT_EVAL_METHOD__) && (__FLT_EVAL_METHOD__ == 2 || __FLT_EVAL_METHOD__ < 0))
inline constexpr bool rounds_as_written = false;
#else
inline constexpr bool rounds_as_written = tells_nan && std::numeric_limits<double>::is_iec559 &&
                                          std::numeric_limits<double>::digits == 53;
#endif

/// Whether error-free sums and products are so. Not every compiler tells what it rearranges, and
/// none how the processor rounds, so some are computed from a number that it does not know.
[[nodiscard]] inline bool sums_are_exact() {
  const volatile double unknown = 1;
  const double one = unknown;
  // Rounding twice, or towards zero, misses the first; rounding upwards the second.
  constexpr double above_half = 0x1p-53 + 0x1p-70;
  constexpr double below_half = 0x1p-54;
  const DoubleDouble up = two_sum(one, above_half);
  const DoubleDouble down = two_sum(one, below_half);
  const DoubleDouble square = two_prod(one + 0x1p-30, one + 0x1p-30);
  return (up.high == 1 + 0x1p-52) & (up.low == above_half - 0x1p-52) & (down.high == 1) &
         (down.low == below_half) & (square.high == 1 + 0x1p-29) & (square.low == 0x1p-60);
}

/// Whether numbers are told from zero that are too small to have all their digits.
[[nodiscard]] inline bool keeps_subnormals() {
  const volatile double least = (std::numeric_limits<double>::min)();
  return least / 2 > 0;
}

}  // namespace assur::numeric
