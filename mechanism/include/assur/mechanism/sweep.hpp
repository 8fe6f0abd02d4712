// Sweeps: configurations along branches over the range of a parameter, and singular events.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace assur::mechanism {

/// One configuration at one step, or one event between or at steps.
struct SweepRecord {
  int step;           ///< for an event, the last step at or before it
  int configuration;  ///< its number among the solution's at this step; 0 for an event
  int branch;         ///< from 1 in order of appearance; 0 for an event
  std::string event;  ///< empty for a configuration; `fold 1 2`: see docs/guide/sweeps.md
  double parameter;   ///< the swept parameter's value
  const Spread* spread;
  const Configuration* state;
};

/// The connections of a sweep's branches. Two are on one circuit if the mechanism can move from one
/// to the other without being taken apart: they meet in one configuration (a fold, a birth, a
/// crossing), or one ends the sweep where the other begins it and the mechanism is the same there,
/// as after a whole turn. Limits of joints are disregarded, and at a degenerate or unresolved event
/// it is unknown whether branches meet.
struct Circuits {
  /// The circuit of branch n, at n - 1. Circuits are numbered from 1 in the order of their first
  /// branches.
  std::vector<int> of_branch;
  /// The branch at the first step that continues branch n, at n - 1, from the last one; 0 if there
  /// is none.
  std::vector<int> next;

  /// The circuit of a branch by its number; 0 if it is unknown, as for branch 0.
  [[nodiscard]] int of(int branch) const { return at(of_branch, branch); }
  /// The next branch of a branch by its number; 0 if there is none.
  [[nodiscard]] int next_of(int branch) const { return at(next, branch); }

 private:
  [[nodiscard]] static int at(const std::vector<int>& numbers, int branch) {
    const auto place = static_cast<std::size_t>(branch);
    return branch > 0 && place <= numbers.size() ? numbers[place - 1] : 0;
  }
};

/// The functions that a sweep calls while it runs, in the order of its progress. Any of them may be
/// omitted.
struct SweepObserver {
  std::function<void(const SweepRecord&)> record;
  /// Gets each step's value of the swept parameter, and its solution, ahead of its records. The
  /// solution includes the configurations beyond the limits of joints.
  std::function<void(double, const Solution&)> solved;
  std::function<void(int)> progress;  ///< steps done
  /// Gets the circuits at the end, since any event may join two.
  std::function<void(const Circuits&)> circuits = {};
};

/// The largest number of branches that are followed side by side.
inline constexpr std::size_t most_followed = 1000;

/// Follows every branch of a mechanism's configurations through its sweep. Two neighbouring sets of
/// configurations are matched as a whole, and the interval is halved until either no match is in
/// doubt or singular events explain it. A match that remains in doubt ends a branch and begins
/// another with an `unresolved` event. Records are reported as they are computed, and not kept.
/// Every step's values are evaluated before the first record, so that an unusable one throws
/// MechanismError before anything is reported; if a formula has no value between two steps, no
/// branch is followed through. Branches are numbered as they appear in records: one that is beyond
/// the limits of joints throughout has no number, unless it is in an event. Returns the number of
/// branches. Throws MechanismError if the plan's request has no sweep.
int sweep(const Plan& plan, const SweepObserver& observer);
/// Does the same with all parameters except the swept one as in `values`.
int sweep(const Plan& plan, const Values& values, const SweepObserver& observer);

/// The circuits of a sweep, and the branches at the swept parameter's own value.
struct SweptPlaces {
  Circuits circuits;
  /// The branches of the configurations that `Plan::solve` lists at that value, in their order; 0
  /// for an unknown branch, and empty if the value is not in the sweep.
  std::vector<int> branches;
};

/// Runs the sweep of a request once, for positions alone; `progress` gets the steps done. Throws
/// MechanismError as `sweep` does.
[[nodiscard]] SweptPlaces swept_places(const Mechanism& mechanism, const Request& request,
                                       const std::function<void(int)>& progress = {});

/// The number of the branch, in the sweep of a request, nearest to the request's reference. If the
/// reference comes from a drawing, this is the branch through the drawn configuration at the swept
/// parameter's own value, if that is in the sweep. Otherwise the configuration is chosen at the
/// first step that has any. Nothing if no step has one. Throws MechanismError as `sweep` does, and
/// for a request without a reference.
[[nodiscard]] std::optional<int> nearest_branch(const Mechanism& mechanism, const Request& request);

/// Follows a single branch, in the memory of one configuration, however many others there are. It
/// begins with a configuration at the first step that has one: the one with the given number, from
/// 1 as `Plan::solve_one` counts, or for zero the one nearest to the request's reference. A step is
/// accepted by the same test as in `sweep`, applied to this configuration and its distance to the
/// next one; otherwise the step is halved. Records have the given number as their branch, and no
/// number of a configuration; there are no events. Returns the value of the parameter at which the
/// branch ends before the sweep does, if any: it folds there, or comes too close to another one to
/// be distinguished. Throws as `sweep` does, and if no step has a configuration of that number or,
/// for the number zero, the request has no reference.
std::optional<double> sweep_branch(const Plan& plan, std::size_t number,
                                   const SweepObserver& observer);
/// Does the same with all parameters except the swept one as in `values`.
std::optional<double> sweep_branch(const Plan& plan, const Values& values, std::size_t number,
                                   const SweepObserver& observer);

}  // namespace assur::mechanism
