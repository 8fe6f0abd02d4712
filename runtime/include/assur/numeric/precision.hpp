// Constants of a scalar's precision, as units of tolerances.
#pragma once

#include <algorithm>
#include <assur/detail/refused_options.hpp>
#include <limits>

namespace assur::numeric {

/// The scalar of the parts of a compound one, in which bounds and sizes are given.
template <typename Scalar>
struct PartOf {
  using Type = Scalar;
};

/// 2^exponent, if the scalar can represent it. For constants only: elsewhere Clang 14 calls it at
/// run time.
template <typename Scalar>
[[nodiscard]] constexpr Scalar power_of_two(int exponent) {
  Scalar power(1);
  for (; exponent > 0; --exponent) {
    power *= Scalar(2);
  }
  for (; exponent < 0; ++exponent) {
    power /= Scalar(2);
  }
  return power;
}

/// Half of the digits: the square of this is about epsilon. A double root is known to this
/// accuracy.
template <typename Scalar>
inline constexpr Scalar half_of_digits =
    power_of_two<Scalar>(-(std::numeric_limits<Scalar>::digits / 2));

/// The factor from a number of roundings in double to as many roundings of another scalar.
template <typename Scalar>
inline constexpr Scalar roundings_of_double =
    power_of_two<Scalar>(std::numeric_limits<double>::digits - std::numeric_limits<Scalar>::digits);

/// The error of a sum of products of a few numbers near one if products of small ones are flushed
/// to zero. In double it is negligible.
template <typename Scalar>
inline constexpr Scalar lost_in_underflow = std::numeric_limits<Scalar>::max_exponent < 1024
                                                ? power_of_two<Scalar>(12) *
                                                      (std::numeric_limits<Scalar>::min)()
                                                : Scalar(0);

/// The correct digits of derivatives in a regular configuration: half of those of the scalar, and
/// at most six. These are six in double and three in float.
template <typename Scalar>
inline constexpr int regular_digits = std::numeric_limits<Scalar>::is_specialized
                                          ? (std::min)(6, std::numeric_limits<Scalar>::digits10 / 2)
                                          : 6;

/// One in the last of these digits: 1e-6 in double, 1e-3 in float.
template <typename Scalar>
inline constexpr double last_regular_digit = [] {
  double power = 1;
  for (int digit = 0; digit < regular_digits<Scalar>; ++digit) {
    power *= 10;
  }
  return 1 / power;
}();

}  // namespace assur::numeric
