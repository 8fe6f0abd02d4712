// Turns an interval in which no set tells all configurations into its branches, followed one by
// one, and their crossings.
#pragma once

#include <optional>
#include <vector>

#include "branch_matching.hpp"
#include "singular_event.hpp"

namespace assur::mechanism::follow {

/// What continues each configuration of the left set, and where several of them go through one
/// configuration. Nothing unless there are few, each is followed through, and each that goes
/// through a singular configuration does so smoothly.
struct OneByOne {
  Table<PointIndex, PointIndex> to_right;
  std::vector<SingularEvent> crossings;
};
[[nodiscard]] std::optional<OneByOne> explained_one_by_one(SnapshotSolver& solver,
                                                           const SnapshotPointer& left,
                                                           const SnapshotPointer& right);

}  // namespace assur::mechanism::follow
