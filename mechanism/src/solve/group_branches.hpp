// Turns a group in a singular configuration among neighbours that move into the motions of its
// branches.
#pragma once

#include <assur/mechanism/group_model.hpp>
#include <vector>

#include "across_axis.hpp"
#include "models/model_kernel.hpp"

namespace assur::mechanism::solve {

/// Rounding by `noise` moves a configuration by noise / s, where s is the ratio of the least
/// singular value of J to the largest. Rates are known to two digits where noise / s^2 is at most
/// this, second rates where noise / s^3 is.
inline constexpr double two_digits_lost = 1e-3;

/// Series like those of a group's dimensions and inputs, but with first and second coefficients as
/// large as the terms whose sums the true ones are.
struct MotionTerms {
  models::FlatSeries d, u;
};

/// A configuration of a group whose inputs move, and whose links may change their shapes: the
/// series of the dimensions d and the inputs u, and the unknowns q at t = 0.
struct GroupOnTheMove {
  const GroupModel& model;
  const models::FlatSeries& d;
  const models::FlatSeries& u;
  const models::FlatVariables& q;
  const std::vector<AcrossOnTheMove>& across;
  const MotionTerms& terms;
  /// How far rounding may have moved the configuration and its neighbours, in parts of their size.
  double displaced;
};

/// One motion through a configuration: the poses of the links.
struct GroupBranch {
  std::array<Pose<models::Series>, models::most_links> poses;
};

/// The motions q(t) with f(q(t), d(t), u(t)) = 0 through a configuration, order by order:
///
///     J q_k = -f_k,    f_k the closures' coefficient without q_k.
///
/// Where J has an inverse there is one motion. Where its rank is one too low, with w J = 0 and
/// J v = 0, there is none unless w f_1 = 0 (at a fold the rates grow beyond all bounds). Otherwise
/// q_1 = p + c v with any c, and the next order decides:  w f_2(c) = A c^2 + B c + C = 0.  Two
/// roots are the two branches of a crossing, and w f_(k + 1) = 0 is linear in the part of q_k along
/// v. With a double root, branches touch or the group is singular throughout: then w f_4 is
/// quadratic in that part of q_2. Coefficients that the known orders do not decide are NaN.
///
/// Also returns no motion where the rank of J is lower still, where A is rounding, or where
/// rounding hides the decision.
[[nodiscard]] std::vector<GroupBranch> branches_through(const GroupOnTheMove& group);

}  // namespace assur::mechanism::solve
