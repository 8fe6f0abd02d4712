// Turns the inverse Jacobian and the curvature of a configuration into how far its derivatives can
// be trusted.
#pragma once

#include <assur/mechanism/group_model.hpp>

#include "models/model_kernel.hpp"

namespace assur::mechanism::solve {

/// A branch whose derivative has a larger relative error cannot be followed.
inline constexpr double one_digit = 5e-2;

/// How far the derivatives of a configuration can be trusted.
struct Precision {
  Status regularity = Status::near_singular;  ///< ok or near_singular
  bool derivatives_known = false;             ///< to two digits at least
  bool path_known = false;                    ///< the same to one digit, by which it is followed
  bool second_rates_known = false;            ///< likewise
};

/// A configuration that its pivots call near-singular gets a second look: their bound multiplies
/// the firmness of parts that need not fail together. Rounding and the neighbours move a
/// configuration by dq = J^-1 df, and that changes the derivatives J^-1 c by J^-1 H(J^-1 c, dq),
/// with H the second derivatives of the closures. Lengths and angles are each counted in parts of
/// their own derivatives. `motion` is that of the configuration `q` of `model`.
[[nodiscard]] Precision precision_of(const GroupModel& model, const models::FlatVariables& d,
                                     const models::FlatVariables& u, const models::FlatVariables& q,
                                     const models::MotionQuery& query,
                                     const models::GroupMotion& motion);

/// Of the frames of links that drivers change, by how firmly features define them: their first
/// rates are multiplied by one over the firmness, and their second ones by its square.
[[nodiscard]] Precision precision_of_shape(double firmness);

}  // namespace assur::mechanism::solve
