// Turns what may be wrong with a result into answers, which the runtime gives instead of
// exceptions.
#pragma once

#include <assur/detail/refused_options.hpp>
#include <limits>

namespace assur {

/// Every operation of the runtime says how far its result can be trusted.
enum class [[nodiscard]] Status : unsigned char{
    ok,                 ///< the result holds
    near_singular,      ///< computed, but fewer digits may hold than `regularity` promises
    singular,           ///< the Jacobian has no inverse here; nothing was computed
    not_finite,         ///< an input is NaN or infinite; nothing was computed
    no_convergence,     ///< Newton's iteration did not settle; the last iterate is returned
    point_at_infinity,  ///< a special point's lines are parallel or nearly; nothing was computed
    /// The program was compiled, without the compiler telling, or the processor is set, so that
    /// rounding has no bound (parts of -ffast-math, the rounding mode); nothing was computed.
    unsound_arithmetic,
};

/// Whether a status comes with a result that was computed.
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
/// eps/margin (see `regularity`), by measurement over all models.
inline constexpr int derivative_error_constant = 64;

/// A derivative with a larger relative error is not known: it has less than two digits.
inline constexpr double two_digits = 5e-3;

/// How far a configuration is from singular, by the pivots of the model's structured elimination.
template <typename Scalar>
struct Regularity {
  /// ok; near_singular where derivatives may keep fewer digits than are promised, six in double and
  /// three in float; singular where there are none; not_finite.
  Status status = Status::singular;
  /// The derivatives' relative error is about rounding/margin: the product of what the core's
  /// determinant keeps of its terms and of how firmly the closures hold the unknowns. One at best,
  /// zero where J has no inverse. It does not depend on the unit of length.
  Scalar margin = Scalar(0);
  /// How firmly the closures hold the unknowns alone: one at best, and no less than the margin.
  Scalar firmness = Scalar(0);
  /// The relative error of the quantities from which the margin is computed, with all constants.
  Scalar rounding = Scalar(1);
  int weakest = 0;  ///< index in Model::pivots of the pivot nearest to zero

  /// A bound on the relative error of the derivatives; infinite where there is no inverse.
  [[nodiscard]] Scalar error() const {
    return margin > Scalar(0) ? rounding / margin : std::numeric_limits<Scalar>::infinity();
  }
  /// Whether velocities are known. Where they are not, rounding hides which of several branches
  /// that meet there a configuration is on.
  [[nodiscard]] bool knows_velocities() const {
    return is_solvable(status) && error() < Scalar(two_digits);
  }
};

}  // namespace assur
