// Follows one branch of a sweep, given by its number, to its end.
#include <algorithm>
#include <assur/mechanism/sweep.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "branch_matching.hpp"
#include "followed_angles.hpp"
#include "snapshot_solver.hpp"
#include "solve/reference.hpp"
#include "sweep_range.hpp"

namespace assur::mechanism::follow {

namespace {

/// The shortest interval, as a part of the sweep and of the parameter's value.
constexpr double shortest_step = 1e-13;

/// Follows one branch from step to step; holds its present configuration and the next one.
class BranchFollower {
 public:
  BranchFollower(const Plan& plan, const Values& values, std::size_t number,
                 const SweepObserver& observer)
      : number_(number), observer_(observer), solver_(plan, values), followed_(plan.mechanism()) {}

  std::optional<double> run() {
    const int count = solver_.sweep().count;
    solver_.expect_values_at_steps();
    for (int step = 0; step < count; ++step) {
      const double value = value_at(step);
      solver_.begin_step();
      if (current_ == nullptr) {
        begin(value);
      } else if (!goes_on_to(value)) {
        return current_->parameter;
      }
      if (current_ != nullptr) {
        report(step);
      }
      observer_.progress(step + 1);
    }
    if (current_ == nullptr) {
      throw MechanismError("sweep",
                           "there is no configuration " +
                               (number_ == 0 ? std::string() : std::to_string(number_) + " ") +
                               "at any step, so there is no branch to follow");
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] double value_at(int step) const {
    return value_at_step(solver_.from(), solver_.to(), step, solver_.sweep().count);
  }

  void begin(double value) {
    const SnapshotPointer first = solver_.one_at(value, number_);
    if (first->count() == 0) {
      observer_.solved(value, first->solution);
      return;
    }
    constexpr double anywhere = std::numeric_limits<double>::infinity();
    current_ = solver_.near(value, first->points[PointIndex(0)].at, anywhere);
    solver_.count_from(current_);
  }

  /// Follows the branch to a value, or to an earlier end. Returns whether it has reached the value.
  [[nodiscard]] bool goes_on_to(double value) {
    const double least =
        shortest_step * std::max(std::abs(solver_.to() - solver_.from()), std::abs(value));
    double width = value - current_->parameter;
    while (current_->parameter != value) {
      const double rest = value - current_->parameter;
      width = std::abs(width) < std::abs(rest) ? width : rest;
      const double next = width == rest ? value : current_->parameter + width;
      const ConfigurationPoint& here = current_->points[PointIndex(0)];
      const SnapshotPointer set =
          solver_.near(next, here.at + (next - current_->parameter) * here.slope,
                       distance_that_matters(here, next - current_->parameter));
      if (goes_on(*current_, *set)) {
        current_ = set;
        solver_.count_from(set);
        width *= 2;
      } else if (std::abs(width) < least) {
        return false;
      } else {
        width /= 2;
      }
    }
    return true;
  }

  void report(int step) {
    observer_.solved(current_->parameter, current_->solution);
    const Configuration& found = current_->configuration(PointIndex(0));
    constexpr int branch = 1;
    const Configuration& state =
        followed_.is_needed() ? followed_.on(branch, found, solver_.values_at(current_->parameter))
                              : found;
    if (state.is_consistent && state.within_limits) {
      observer_.record(
          {step, 0, static_cast<int>(number_), "", current_->parameter, &current_->spread, &state});
    }
  }

  std::size_t number_;
  const SweepObserver& observer_;
  SnapshotSolver solver_;
  FollowedAngles followed_;
  SnapshotPointer current_;  ///< the branch, as far as it has been followed
};

}  // namespace

}  // namespace assur::mechanism::follow

namespace assur::mechanism {

std::optional<double> sweep_branch(const Plan& plan, std::size_t number,
                                   const SweepObserver& observer) {
  return sweep_branch(plan, plan.values(), number, observer);
}

std::optional<double> sweep_branch(const Plan& plan, const Values& values, std::size_t number,
                                   const SweepObserver& observer) {
  if (number == 0) {
    solve::expect_reference(plan.request());
  }
  const SweepObserver complete = follow::expect_sweep(plan, values, observer);
  return follow::BranchFollower(plan, values, number, complete).run();
}

}  // namespace assur::mechanism
