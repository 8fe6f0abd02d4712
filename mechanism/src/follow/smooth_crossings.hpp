// Branches of an interval that go through singular configurations, and the crossings of those that
// share one.
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

/// Takes each configuration whose match is not clear through the singular point to which its
/// tangent leads. All constraints together locate that point, and verify that it is open by
/// rounding at most. The branch continues with the tangent and bend of its approach, to the only
/// configuration near the prediction; the prediction from there must lead back. Returns nothing if
/// this fails for one of them, or where laws read joints.
[[nodiscard]] std::optional<CrossedBranches> smooth_crossings(SnapshotSolver& solver,
                                                              const SnapshotPointer& left,
                                                              const SnapshotPointer& right,
                                                              const BranchMatching& matching);

}  // namespace assur::mechanism::follow
