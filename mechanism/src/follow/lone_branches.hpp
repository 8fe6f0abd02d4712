// Turns one configuration into the one that continues it, past sets in which rounding hides others.
#pragma once

#include <map>
#include <optional>

#include "snapshot.hpp"

namespace assur::mechanism::follow {

/// A configuration of a set, on the branch that goes through it.
struct BranchPoint {
  SnapshotPointer set;
  PointIndex point;

  [[nodiscard]] const ConfigurationPoint& here() const { return set->points[point]; }
  [[nodiscard]] const Configuration& state() const { return set->configuration(point); }
  /// Whether the branch can be followed from here.
  [[nodiscard]] bool is_known() const;
};

/// Follows branches one by one. Behind groups that are singular at one value the rounding of each
/// is the error of the next, so that a slow branch is lost sooner than one that turns fast, and no
/// set near that value tells all: but each branch has steps that lead past it.
class LoneBranches {
 public:
  explicit LoneBranches(SnapshotSolver& solver) : solver_(solver) {}

  /// What continues a configuration at another value, on either side of it: after each step the
  /// only one near to where the last led, and the only one from which that is near. Nothing if
  /// there is no way of such steps.
  [[nodiscard]] std::optional<BranchPoint> continued(BranchPoint from, double parameter);

  [[nodiscard]] SnapshotSolver& solver() const { return solver_; }

 private:
  [[nodiscard]] SnapshotPointer at(double parameter);

  SnapshotSolver& solver_;
  std::map<double, SnapshotPointer> kept_;  ///< what several branches are asked for
};

}  // namespace assur::mechanism::follow
