// Turns a planned mechanism with a sweep into configurations along branches, and singular events.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <functional>
#include <optional>
#include <string>

namespace assur::mechanism {

/// One configuration at one step, or one event between or at steps.
struct SweepRecord {
  int step;           ///< for an event, the last step that is not beyond it
  int configuration;  ///< its number among the solution's at this step; 0 for an event
  int branch;         ///< from 1 in order of appearance; 0 for an event
  std::string event;  ///< empty for a configuration; `fold 1 2`: see docs/guide/sweeps.md
  double parameter;   ///< the swept parameter's value
  const Spread* spread;
  const Configuration* state;
};

/// The functions that a sweep calls while it runs, in its order. Any of them may be left out.
struct SweepObserver {
  std::function<void(const SweepRecord&)> record;
  /// Gets each step's value of the swept parameter, and its solution, ahead of its records. The
  /// solution includes the configurations beyond the limits of joints.
  std::function<void(double, const Solution&)> solved;
  std::function<void(int)> progress;  ///< steps done
};

/// The largest number of branches that are followed side by side.
inline constexpr std::size_t most_followed = 1000;

/// Follows every branch of a mechanism's configurations through its sweep. Two neighbouring sets of
/// configurations are matched as a whole, and the interval is halved until either no match is in
/// doubt or singular events explain it. A match that stays in doubt ends a branch and begins
/// another with an `unresolved` event. Records are reported as they are computed, and none is kept.
/// Every step's values are evaluated before the first record, so that one that cannot be used
/// throws MechanismError before anything is reported; where a formula has no value between two
/// steps, no branch is followed through. Branches are numbered as they appear in records: one that
/// is beyond the limits of joints throughout has no number, unless an event names it. Returns the
/// number of branches. Throws MechanismError where the plan's request has no sweep.
int sweep(const Plan& plan, const SweepObserver& observer);
/// Does the same with all parameters but the swept one as in `values`.
int sweep(const Plan& plan, const Values& values, const SweepObserver& observer);

/// The number of the branch, in the sweep of a request, that is nearest to the request's reference.
/// Where that is the one of a drawing, it is the branch that goes through the drawn configuration
/// at the swept parameter's own value, if that is in the sweep. Otherwise the configuration is
/// chosen at the first step that has any. Nothing where no step has one. Throws MechanismError as
/// `sweep` does, and for a request without a reference.
[[nodiscard]] std::optional<int> nearest_branch(const Mechanism& mechanism, const Request& request);

/// Follows a single branch, in the memory of one configuration, however many others there are. It
/// begins with a configuration at the first step that has one: the one with the given number, from
/// 1 as `Plan::solve_one` counts, or for zero the one nearest to the request's reference. A step is
/// accepted by the same test as in `sweep`, applied to this configuration and its distance to the
/// next one; otherwise the step is halved. Records have the given number as their branch, and no
/// number of a configuration; there are no events. Returns the value of the parameter at which the
/// branch ends before the sweep does, if any: it folds there, or comes too close to another one to
/// be told apart. Throws as `sweep` does, and where no step has a configuration of that number or,
/// for the number zero, the request has no reference.
std::optional<double> sweep_branch(const Plan& plan, std::size_t number,
                                   const SweepObserver& observer);
/// Does the same with all parameters but the swept one as in `values`.
std::optional<double> sweep_branch(const Plan& plan, const Values& values, std::size_t number,
                                   const SweepObserver& observer);

}  // namespace assur::mechanism
