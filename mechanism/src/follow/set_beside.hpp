// Turns a step at which configurations cannot be followed into a set beside it at which they can.
#pragma once

#include "snapshot.hpp"

namespace assur::mechanism::follow {

/// One side of a step.
struct StepSide {
  int step;
  SnapshotPointer set;  ///< at the step
  int side;             ///< -1 before it, 1 behind it, in the sense of the sweep
};

/// The nearest set that can be followed, on one side of a step; not behind what is followed
/// already, which is null if nothing is, nor beyond the neighbours of the step where sets tell no
/// configurations. Null if there is none.
[[nodiscard]] SnapshotPointer set_beside(SnapshotSolver& solver, const SnapshotPointer& followed,
                                         const StepSide& of);

}  // namespace assur::mechanism::follow
