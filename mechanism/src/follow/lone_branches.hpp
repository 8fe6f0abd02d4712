// Turns one configuration into the one that continues it, past sets in which rounding hides other
// configurations.
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

/// Follows branches one by one. Where groups behind one another are singular at one value, the
/// rounding of each is the error of the next. A slow branch is then lost sooner than one that turns
/// fast, and no set near that value shows all branches; but for each branch there are steps that
/// lead past it.
class LoneBranches {
 public:
  explicit LoneBranches(SnapshotSolver& solver) : solver_(solver) {}

  /// The configuration that continues one at another value, before or after it. Each step goes to
  /// the only configuration near to where the last one led, and must be the only one that leads
  /// there. Returns nothing if no such steps lead to that value.
  [[nodiscard]] std::optional<BranchPoint> continued(BranchPoint from, double parameter);

  [[nodiscard]] SnapshotSolver& solver() const { return solver_; }

 private:
  [[nodiscard]] SnapshotPointer at(double parameter);

  SnapshotSolver& solver_;
  std::map<double, SnapshotPointer> kept_;  ///< sets that several branches use
};

}  // namespace assur::mechanism::follow
