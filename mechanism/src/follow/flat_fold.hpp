// Location of folds of higher order.
#pragma once

#include "fold_location.hpp"
#include "snapshot_solver.hpp"

namespace assur::mechanism::follow {

/// The fold of a pair at which the parameter does not change to third order along the branch, for
/// example due to symmetry: p = p* - a s^4 - b s^6 ..., where s is the separation, which vanishes
/// as the fourth root of the distance. Returns nothing if the pair does not approach in this way.
[[nodiscard]] std::optional<EventLocation> locate_flat_fold(SnapshotSolver& solver,
                                                            const ConfigurationPair& near);

}  // namespace assur::mechanism::follow
