// Turns the margin of a configuration from singular ones into the digits that its derivatives keep.
#pragma once

#include <assur/numeric/precision.hpp>
#include <assur/status.hpp>
#include <limits>

namespace assur::support {

/// The relative error of a derivative is at most this over the margin; see `regularity`.
template <typename Scalar>
[[nodiscard]] Scalar derivative_rounding() {
  return Scalar(derivative_error_constant) * std::numeric_limits<Scalar>::epsilon();
}

/// The relative error that a regular configuration promises of its derivatives: 5e-7 in double,
/// which is six digits; 5e-4 in float, three.
template <typename Scalar>
inline constexpr double regular_error = numeric::last_regular_digit<Scalar> / 2;
inline constexpr double six_digits = regular_error<double>;

}  // namespace assur::support
