// Turns configurations near a singular one into its parameter value and the configuration there.
#pragma once

#include <optional>

#include "snapshot.hpp"

namespace assur::mechanism::follow {

/// Where a singular event happens. Its rates and gradients are not numbers.
struct EventLocation {
  double parameter;
  Configuration configuration;
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

/// The crossing of two branches that go from `left` to `right`, first to first. The separation is
/// analytic in the parameter and changes its sign; sampled at several widths, since rounding
/// spoils what is near and truncation what is far, and the widths that agree best are taken.
[[nodiscard]] std::optional<EventLocation> locate_crossing(SnapshotSolver& solver,
                                                           const ConfigurationPair& left,
                                                           const ConfigurationPair& right);

/// Where a configuration of a set runs to infinity: the zero of 1 / (w . X), w its direction.
[[nodiscard]] std::optional<EventLocation> locate_escape(SnapshotSolver& solver,
                                                         const SnapshotPointer& near,
                                                         PointIndex index);
/// The first estimate of the same, as a distance from a point.
[[nodiscard]] double distance_to_escape(const ConfigurationPoint& point);

/// A configuration of a mechanism with nothing known.
[[nodiscard]] Configuration unknown_configuration(const Plan& plan);

}  // namespace assur::mechanism::follow
