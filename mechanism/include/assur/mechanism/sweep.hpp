// Turns a planned mechanism with a sweep into configurations along branches, and singular events.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <functional>
#include <optional>
#include <string>

namespace assur::mechanism {

/// One configuration at one step, or one event between or at steps.
struct SweepRecord {
  int step;           ///< of an event: the last one not beyond it
  int configuration;  ///< its number among the solution's at this step; 0 for an event
  int branch;         ///< from 1 in order of appearance; 0 for an event
  std::string event;  ///< empty for a configuration; `fold 1 2`: see docs/guide/sweeps.md
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

/// The largest number of branches that are followed side by side.
inline constexpr std::size_t most_followed = 1000;

/// Follows every branch of a mechanism's configurations through its sweep. Two neighbouring sets of
/// configurations are matched as a whole, and the interval is halved until either no match is open
/// to doubt or singular events explain it. What stays in doubt ends and begins branches with an
/// `unresolved` event. Records are reported as they are computed, and none is kept. Every step's
/// values are evaluated before the first record, so that one that cannot be used throws
/// MechanismError before anything is reported; where a formula has no value between two steps, no
/// branch is followed through. Branches are numbered as they appear in records: what is beyond the
/// limits of joints throughout has no number, unless an event befalls it. Returns how many there
/// are. Throws MechanismError where the plan's request has no sweep.
int sweep(const Plan& plan, const SweepObserver& observer);
/// The same with all parameters but the swept one as in `values`.
int sweep(const Plan& plan, const Values& values, const SweepObserver& observer);

/// Follows a single branch, in the memory of one configuration, however many others there are. It
/// is that of a configuration at the first step that has one: by its number, from 1 and as
/// `Plan::solve_one` counts, or where that is zero of the one nearest to the request's reference. A
/// step is taken for one of the same branch by what `sweep` asks of two neighbouring sets, of this
/// configuration alone and of its distance to the next; otherwise it is halved. Records have the
/// given number as their branch, and no number of a configuration; there are no events. Returns at
/// which value of the parameter the branch ends, if it does before the sweep: it folds there, or
/// comes too close to another to be told apart. Throws as `sweep` does, and where no step has a
/// configuration of that number or, for the number zero, the request has no reference.
std::optional<double> sweep_branch(const Plan& plan, std::size_t number,
                                   const SweepObserver& observer);

}  // namespace assur::mechanism
