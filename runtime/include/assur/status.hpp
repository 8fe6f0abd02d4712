// The answers that the runtime gives instead of exceptions.
#pragma once

namespace assur {

/// Every operation of the runtime says how far its result can be trusted.
enum class Status : unsigned char {
  ok,                 ///< the result holds
  near_singular,      ///< computed, but fewer than six digits may hold
  singular,           ///< the Jacobian has no inverse here; nothing was computed
  not_finite,         ///< an input is NaN or infinite; nothing was computed
  no_convergence,     ///< Newton's iteration did not settle; the last iterate is returned
  point_at_infinity,  ///< a special point's lines are parallel or nearly; nothing was computed
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
  }
  return "unknown";
}

}  // namespace assur
