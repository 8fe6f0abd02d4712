// Accuracy of a configuration's derivatives, from its inverse Jacobian and its curvature.
#pragma once

#include <assur/mechanism/group_model.hpp>

#include "models/model_kernel.hpp"

namespace assur::mechanism::solve {

/// A branch whose derivative has a larger relative error cannot be followed.
inline constexpr double one_digit = 5e-2;

/// Which derivatives of a configuration are known.
struct Precision {
  Status regularity = Status::near_singular;  ///< ok or near_singular
  bool derivatives_known = false;             ///< to two digits at least
  bool path_known = false;                    ///< to one digit, enough to follow its branch
  bool second_rates_known = false;            ///< to two digits at least
};

/// The precision of a configuration that its pivots report as near-singular. Their bound is
/// pessimistic, since it multiplies the firmness of parts that need not fail together. Rounding and
/// the neighbours move a configuration by dq = J^-1 df, and that changes the derivatives J^-1 c by
/// J^-1 H(J^-1 c, dq), with H the second derivatives of the closures. Errors of lengths and of
/// angles are each relative to their own derivatives. `motion` is that of the configuration `q` of
/// `model`.
[[nodiscard]] Precision precision_of(const GroupModel& model, const models::FlatVariables& d,
                                     const models::FlatVariables& u, const models::FlatVariables& q,
                                     const models::MotionQuery& query,
                                     const models::GroupMotion& motion);

/// The precision of the frames of links that drivers change. `firmness`, from 0 to 1, measures how
/// well features define the frame: rounding errors of first rates grow by its inverse, and those of
/// second rates by the square of its inverse.
[[nodiscard]] Precision precision_of_shape(double firmness);

}  // namespace assur::mechanism::solve
