// States of one branch of an emitted solver, followed through columns of drivers.
#pragma once

#include <assur/support/scene_batch.hpp>
#include <assur/support/scene_track.hpp>
#include <cstddef>

namespace assur::support {

/// The caller's arrays for the states of a branch, one for each instance.
template <typename Solver>
struct TrackedStates {
  /// The status of `track` for the instance: ok or near_singular for a state on the branch within
  /// the joint limits, otherwise a gap. A state beyond the limits has no_convergence, although the
  /// branch passes through it.
  Status* status = nullptr;
  /// Number p (see `column_numbers`) of instance i is at [p * stride + i]; NaN in a gap.
  double* states = nullptr;
  std::size_t stride = 0;
};

/// Follows a branch from its present point to `count` sets of drivers, and of parameters if the
/// solver has any, one after the other. A set that the branch does not reach is a gap; the next one
/// is followed from the last point reached. Returns the number of sets on the branch.
template <typename Solver>
std::size_t track_batch(std::size_t count, const GivenColumns& drivers,
                        const GivenColumns& parameters, Branch<Solver, double>& branch,
                        const TrackedStates<Solver>& result) {
  const LoneInstances<Solver> instances{drivers, parameters, {}};
  std::size_t reached = 0;
  for (std::size_t instance = 0; instance < count; ++instance) {
    const auto given =
        instances.template given_at<double>(instance, [](const double* number) { return *number; });
    typename Solver::template State<double> state;
    clear_state(state);
    const auto way = Tracker<Solver, double>::run(given, branch, state);
    Status status = way.status;
    if constexpr (Access<Solver, double>::has_limits) {
      if (is_solvable(status) && !way.within_limits) {
        clear_state(state);
        status = Status::no_convergence;
      }
    }
    result.status[instance] = status;
    reached += is_solvable(status) ? 1 : 0;
    for_each_column(state, [&](double& number, std::size_t column) {
      result.states[column * result.stride + instance] = number;
    });
  }
  return reached;
}

/// The same for a solver without variable parameters.
template <typename Solver>
std::size_t track_batch(std::size_t count, const GivenColumns& drivers,
                        Branch<Solver, double>& branch, const TrackedStates<Solver>& result) {
  return track_batch<Solver>(count, drivers, {}, branch, result);
}

}  // namespace assur::support
