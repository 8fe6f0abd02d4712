// Error bounds of derivatives from the margin of a configuration.
#pragma once

#include <assur/numeric/precision.hpp>
#include <assur/status.hpp>
#include <limits>

namespace assur::support {

/// The relative error of a derivative is at most this divided by the margin; see `regularity`.
template <typename Scalar>
[[nodiscard]] Scalar derivative_rounding() {
  return Scalar(derivative_error_constant) * std::numeric_limits<Scalar>::epsilon();
}

/// The bound on the relative error of derivatives in a regular configuration: 5e-7 in double (six
/// digits), 5e-4 in float (three digits).
template <typename Scalar>
inline constexpr double regular_error = numeric::last_regular_digit<Scalar> / 2;
inline constexpr double six_digits = regular_error<double>;

}  // namespace assur::support
