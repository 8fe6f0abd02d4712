// Turns an interval in which no set shows all configurations into its branches, followed one by
// one, and their crossings.
#pragma once

#include <optional>
#include <vector>

#include "branch_matching.hpp"
#include "singular_event.hpp"

namespace assur::mechanism::follow {

/// The configuration that continues each one of the left set, and the crossings where several of
/// them go through one configuration.
struct OneByOne {
  Table<PointIndex, PointIndex> to_right;
  std::vector<SingularEvent> crossings;
};
/// Follows each configuration of the left set to the right one. Returns nothing unless there are
/// few of them, each can be followed through, and each that goes through a singular configuration
/// does so smoothly.
[[nodiscard]] std::optional<OneByOne> explained_one_by_one(SnapshotSolver& solver,
                                                           const SnapshotPointer& left,
                                                           const SnapshotPointer& right);

}  // namespace assur::mechanism::follow
