// The branches of an interval in which some go through singular configurations, and the crossings
// where several go through one.
#pragma once

#include <optional>
#include <vector>

#include "branch_matching.hpp"
#include "singular_event.hpp"
#include "snapshot_solver.hpp"

namespace assur::mechanism::follow {

/// The configuration of the right set that continues each one of the left set, and the crossings
/// between them, in the order of the sweep.
struct CrossedBranches {
  Table<PointIndex, PointIndex> to_right;
  std::vector<SingularEvent> crossings;
};

/// Takes each configuration whose match is not clear through the singular point that its tangent
/// leads to. All constraints together locate that point, and tell that it is not open by more than
/// rounding. The branch goes on with the tangent and the bend with which it comes, to the only
/// configuration near to where these lead; seen from there, they must lead back. Returns nothing if
/// this is not so for all of them, or where laws read joints.
[[nodiscard]] std::optional<CrossedBranches> smooth_crossings(SnapshotSolver& solver,
                                                              const SnapshotPointer& left,
                                                              const SnapshotPointer& right,
                                                              const BranchMatching& matching);

}  // namespace assur::mechanism::follow
