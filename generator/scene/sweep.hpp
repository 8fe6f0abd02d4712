// Turns a scene with a sweep into configurations along branches, and the singular events between.
#pragma once

#include <functional>
#include <string>

#include "scene/singular_event.hpp"

namespace assur::generator {

/// One configuration at one step, or one event between or at steps.
struct SweepRecord {
  int step;           ///< of an event: the last one not beyond it
  int configuration;  ///< its number among the solution's at this step; 0 for an event
  int branch;         ///< from 1 in order of appearance; 0 for an event
  std::string event;  ///< empty for a configuration; `fold 1 2`: see docs/sweeps.md
  const ParameterValues* values;
  const AssemblyConfiguration* state;
};

/// What a sweep reports while it runs. All are called in the order of the sweep.
struct SweepObserver {
  std::function<void(const SweepRecord&)> record;
  std::function<void(const Solution&)> solved;  ///< each step's solution, ahead of its records
  std::function<void(int)> progress;            ///< steps done
};

/// Follows every branch of a scene's configurations through its sweep. Two neighbouring sets of
/// configurations are matched as a whole (see `match`), and the interval is halved until either no
/// match is open to doubt or singular events explain it. What stays in doubt ends and begins
/// branches with an `unresolved` event. Throws InputError as `solve` does.
void sweep(const Scene& scene, const SweepObserver& observer);

}  // namespace assur::generator
