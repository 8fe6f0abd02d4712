// Turns configurations near a singular one into its parameter value and the configuration there.
#pragma once

#include <optional>
#include <vector>

#include "snapshot.hpp"

namespace assur::mechanism::follow {

/// Where a singular event happens. Its rates and gradients are not numbers.
struct EventLocation {
  double parameter;
  Configuration configuration;
  double uncertainty = 0;  ///< of the parameter, by rounding
};

/// Two configurations of one set.
struct ConfigurationPair {
  SnapshotPointer set;
  PointIndex one, other;

  [[nodiscard]] const ConfigurationPoint& first() const;
  [[nodiscard]] const ConfigurationPoint& second() const;
  [[nodiscard]] Eigen::VectorXd apart() const { return second().at - first().at; }
  [[nodiscard]] double separation() const { return apart().norm(); }
  /// To the fold, if there is one near: the squared separation is linear in the parameter there.
  [[nodiscard]] double distance_to_fold() const;
};

/// Follows a pair to the fold where it meets. Along the branch through a fold both the parameter
/// and the configuration are analytic in g = dp / d(v . X), v the direction between the two; each
/// configuration near it gives one exact g, and the fold is at g = 0. `through` tells that a third
/// branch passes there, so that the Jacobian loses digits sooner.
[[nodiscard]] std::optional<EventLocation> locate_fold(SnapshotSolver& solver,
                                                       const ConfigurationPair& near, bool through);

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
/// analytic in the parameter and changes its sign; sampled at several widths, since rounding
/// spoils what is near and truncation what is far, and the widths that agree best are taken.
/// Nothing if the branches do not go through smoothly: where a crossing is opened by a gap w, each
/// differs from a smooth one by w^2 / separation, and the product of both may not exceed `limit`.
[[nodiscard]] std::optional<EventLocation> locate_crossing(SnapshotSolver& solver,
                                                           const ConfigurationBundle& left,
                                                           const ConfigurationBundle& right,
                                                           double limit);

/// Where a configuration of a set runs to infinity: the zero of 1 / (w . X), w its direction.
[[nodiscard]] std::optional<EventLocation> locate_escape(SnapshotSolver& solver,
                                                         const SnapshotPointer& near,
                                                         PointIndex index);
/// The first estimate of the same, as a distance from a point.
[[nodiscard]] double distance_to_escape(const ConfigurationPoint& point);

/// A configuration of a mechanism with nothing known.
[[nodiscard]] Configuration unknown_configuration(const Plan& plan);

}  // namespace assur::mechanism::follow
