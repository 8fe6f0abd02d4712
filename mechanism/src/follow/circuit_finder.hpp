// Circuits of a sweep's branches, from events and the rows of steps.
#pragma once

#include <assur/mechanism/sweep.hpp>
#include <vector>

#include "shown_branches.hpp"
#include "snapshot_solver.hpp"

namespace assur::mechanism::follow {

/// The places of all features on their links, and the coordinates of the drivers whose laws read no
/// joint: they are the same where the mechanism is the same.
struct Shapes {
  std::vector<double> lengths;  ///< relative to the mechanism's
  std::vector<double> angles;   ///< of revolute drivers
};

/// Joins the branches of a sweep into circuits, by the tracker's numbers.
class CircuitFinder {
 public:
  explicit CircuitFinder(SnapshotSolver& solver) : solver_(solver) {}

  /// Joins the branches that meet in an event's configuration, if it has one.
  void join_at(const BranchEvent& event);
  /// Joins branches that share a configuration of a step, and those that return to a configuration
  /// of the first step, if the mechanism is the same there.
  void join_at_step(double parameter, const std::vector<StepRow>& rows);
  /// The circuits of the shown branches. Branches that end the sweep at its last value must have
  /// been joined last.
  [[nodiscard]] Circuits found(const ShownBranches& told);

 private:
  /// A branch at the first step.
  struct Start {
    int branch;
    Eigen::VectorXd at;
  };
  void join(int one, int other);
  /// The least branch that another is joined with.
  [[nodiscard]] int first_of(int branch);
  [[nodiscard]] Shapes shapes_at(double parameter);

  SnapshotSolver& solver_;
  std::vector<int> joined_with_;  ///< another branch of the same circuit, none greater
  Shapes shapes_;                 ///< at the first step
  std::vector<Start> starts_;
  bool has_begun_ = false;
  std::vector<std::pair<int, int>> next_;  ///< at the last step: a branch, and its continuation
};

}  // namespace assur::mechanism::follow
