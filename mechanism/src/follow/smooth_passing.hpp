// Turns one branch on both sides of a value at which its groups are singular into how it passes
// that.
#pragma once

#include <optional>

#include "event_location.hpp"
#include "lone_branches.hpp"

namespace assur::mechanism::follow {

/// Where a branch goes through a singular configuration, and how smoothly.
struct SmoothPassing {
  EventLocation location;
  Eigen::VectorXd place;
  Eigen::VectorXd slope;
  /// The square of the gap between this branch and one that it would turn off to, were it open.
  double opening;
};

/// Whether the determinant of a group has another sign at the second point.
[[nodiscard]] bool is_turned(const BranchPoint& from, const BranchPoint& to);

/// The second point is what continues the first. The singular value is the zero of the determinant
/// of the first group that turns there, for all groups before it are regular. Places and slopes on
/// both sides tell where a smooth branch is between them, at a ladder of widths: rounding spoils
/// what is near, and truncation what is far. Nothing if no group turns, or rounding leaves no
/// width.
[[nodiscard]] std::optional<SmoothPassing> passing(LoneBranches& branches, const BranchPoint& from,
                                                   const BranchPoint& to);

}  // namespace assur::mechanism::follow
