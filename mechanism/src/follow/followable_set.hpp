// Nearest set beside a step from which branches can be followed.
#pragma once

#include "snapshot_solver.hpp"

namespace assur::mechanism::follow {

/// One side of a step.
struct StepSide {
  int step;
  SnapshotPointer set;  ///< at the step
  int side;             ///< -1 before it, 1 behind it, in the direction of the sweep
};

/// The nearest set that can be followed on one side of a step. The search does not pass `followed`,
/// the last set of the branches (null if there is none), nor go far beyond the step's neighbours
/// where solutions are degenerate. Null if there is none.
[[nodiscard]] SnapshotPointer nearest_followable_set(SnapshotSolver& solver,
                                                     const SnapshotPointer& followed,
                                                     const StepSide& of);

}  // namespace assur::mechanism::follow
