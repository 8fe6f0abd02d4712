// Statuses of results, which the runtime returns instead of throwing, and the regularity of a
// configuration.
#pragma once

#include <assur/detail/refused_options.hpp>
#include <limits>

namespace assur {

/// The outcome of an operation.
enum class [[nodiscard]] Status : unsigned char{
    ok,                 ///< the result is valid
    near_singular,      ///< computed, perhaps with fewer correct digits than `regularity` promises
    singular,           ///< the Jacobian has no inverse here; nothing was computed
    not_finite,         ///< an input is NaN or infinite; nothing was computed
    no_convergence,     ///< Newton's method did not converge; the last iterate is returned
    point_at_infinity,  ///< a special point's lines are parallel or nearly; nothing was computed
    /// Rounding errors have no bound, because of parts of -ffast-math that the compiler does not
    /// report or of the processor's rounding mode; nothing was computed.
    unsound_arithmetic,
};

/// Whether the status is ok or near_singular: a result was computed.
[[nodiscard]] constexpr bool is_solvable(Status status) {
  return status == Status::ok || status == Status::near_singular;
}

[[nodiscard]] constexpr const char* to_string(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::near_singular:
      return "near-singular";
    case Status::singular:
      return "singular";
    case Status::not_finite:
      return "not finite";
    case Status::no_convergence:
      return "no convergence";
    case Status::point_at_infinity:
      return "point at infinity";
    case Status::unsound_arithmetic:
      return "unsound arithmetic";
  }
  return "unknown";
}

/// The relative error of the sensitivities, among unknowns of one unit, is at most this times
/// eps/margin (see `regularity`), as measured over all models.
inline constexpr int derivative_error_constant = 64;

/// A derivative with a larger relative error counts as unknown: it has fewer than two correct
/// digits.
inline constexpr double two_digits = 5e-3;

/// The distance of a configuration from singular ones, by the pivots of the model's structured
/// elimination.
template <typename Scalar>
struct Regularity {
  /// ok; near_singular if derivatives may have fewer correct digits than the promised six in double
  /// or three in float; singular if they do not exist; not_finite.
  Status status = Status::singular;
  /// The derivatives' relative error is about rounding/margin. The margin is the product of the
  /// firmness and of the core's determinant divided by the size of its terms. One at best, zero if
  /// J has no inverse. It does not depend on the unit of length.
  Scalar margin = Scalar(0);
  /// How firmly the closures determine the unknowns: one at best, and no less than the margin.
  Scalar firmness = Scalar(0);
  /// The relative error of the quantities from which the margin is computed, constants included.
  Scalar rounding = Scalar(1);
  int weakest = 0;  ///< index in Model::pivots of the pivot nearest to zero

  /// A bound on the relative error of the derivatives; infinite if J has no inverse.
  [[nodiscard]] Scalar error() const {
    return margin > Scalar(0) ? rounding / margin : std::numeric_limits<Scalar>::infinity();
  }
  /// Whether velocities are determined. If not, rounding hides on which of several meeting branches
  /// the configuration lies.
  [[nodiscard]] bool knows_velocities() const {
    return is_solvable(status) && error() < Scalar(two_digits);
  }
};

}  // namespace assur
