// Turns a planned mechanism with a sweep into configurations along branches, and singular events.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <functional>
#include <string>

namespace assur::mechanism {

/// One configuration at one step, or one event between or at steps.
struct SweepRecord {
  int step;           ///< of an event: the last one not beyond it
  int configuration;  ///< its number among the solution's at this step; 0 for an event
  int branch;         ///< from 1 in order of appearance; 0 for an event
  std::string event;  ///< empty for a configuration; `fold 1 2`: see docs/sweeps.md
  double parameter;   ///< the swept parameter's value
  const Spread* spread;
  const Configuration* state;
};

/// What a sweep reports while it runs, in its order. Any of them may be left out.
struct SweepObserver {
  std::function<void(const SweepRecord&)> record;
  /// Each step's value of the swept parameter, and its solution, ahead of its records. The solution
  /// has the configurations beyond the limits of joints, too.
  std::function<void(double, const Solution&)> solved;
  std::function<void(int)> progress;  ///< steps done
};

/// Follows every branch of a mechanism's configurations through its sweep. Two neighbouring sets of
/// configurations are matched as a whole, and the interval is halved until either no match is open
/// to doubt or singular events explain it. What stays in doubt ends and begins branches with an
/// `unresolved` event. Records are reported as they are computed, and none is kept. Every step's
/// values are evaluated before the first record, so that one that cannot be used throws
/// MechanismError before anything is reported; where a formula has no value between two steps, no
/// branch is followed through. Throws MechanismError where the plan's request has no sweep.
void sweep(const Plan& plan, const SweepObserver& observer);
/// The same with all parameters but the swept one as in `values`.
void sweep(const Plan& plan, const Values& values, const SweepObserver& observer);

}  // namespace assur::mechanism
