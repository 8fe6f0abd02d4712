// Location of the crossing of branches that are known on both sides.
#pragma once

#include <optional>
#include <vector>

#include "event_location.hpp"
#include "snapshot_solver.hpp"

namespace assur::mechanism::follow {

/// The largest square of a gap between two branches that still counts as a crossing: rounding of
/// the lengths can open a crossing by this gap.
inline constexpr double crossing_limit = 1e-13;

/// Configurations of one set, on branches that meet.
struct ConfigurationBundle {
  SnapshotPointer set;
  std::vector<PointIndex> points;

  [[nodiscard]] std::size_t count() const { return points.size(); }
  [[nodiscard]] const ConfigurationPoint& at(std::size_t index) const {
    return set->points[points[index]];
  }
  [[nodiscard]] Eigen::VectorXd middle() const;
};

/// The crossing of branches that go from `left` to `right`, first to first. Their spread is
/// analytic in the parameter and changes its sign. It is sampled at several widths, since rounding
/// spoils narrow ones and truncation wide ones, and the two widths that agree best decide. Returns
/// nothing if the branches do not pass smoothly: a gap w at the crossing moves each branch by w^2 /
/// separation from a smooth one, and the product of both may not exceed `crossing_limit`.
[[nodiscard]] std::optional<EventLocation> locate_crossing(SnapshotSolver& solver,
                                                           const ConfigurationBundle& left,
                                                           const ConfigurationBundle& right);

/// Whether a set has one configuration at a place, rather than two beside it or none. This detects
/// a gap that is hidden by the rounding of the branches.
[[nodiscard]] bool is_one(const Snapshot& set, const Eigen::VectorXd& place);

}  // namespace assur::mechanism::follow
