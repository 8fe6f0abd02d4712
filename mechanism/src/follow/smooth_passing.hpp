// Turns one branch on both sides of a value at which its groups are singular into how it passes
// that value.
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
  /// The square of the gap that would separate this branch from one onto which it turns, if the
  /// crossing were open.
  double opening;
};

/// Whether the determinant of any group changes its sign between the two points.
[[nodiscard]] bool is_turned(const BranchPoint& from, const BranchPoint& to);

/// How a branch passes between two points, the second of which continues the first. The singular
/// value is the zero of the determinant of the first group whose sign changes, for all groups
/// before it are regular. Places and slopes on both sides determine where a smooth branch is
/// between them. They are taken at several widths, since rounding spoils narrow ones and truncation
/// wide ones. Returns nothing if no sign changes, or if rounding leaves no width.
[[nodiscard]] std::optional<SmoothPassing> passing(LoneBranches& branches, const BranchPoint& from,
                                                   const BranchPoint& to);

}  // namespace assur::mechanism::follow
