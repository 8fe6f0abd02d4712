// Location of the fold in which two configurations meet.
#pragma once

#include <optional>

#include "event_location.hpp"
#include "snapshot_solver.hpp"

namespace assur::mechanism::follow {

/// Two configurations of one set.
struct ConfigurationPair {
  SnapshotPointer set;
  PointIndex one, other;

  [[nodiscard]] const ConfigurationPoint& first() const;
  [[nodiscard]] const ConfigurationPoint& second() const;
  [[nodiscard]] Eigen::VectorXd apart() const { return second().at - first().at; }
  [[nodiscard]] double separation() const { return apart().norm(); }
  /// The estimated parameter distance to the fold, if one is near: the squared separation is linear
  /// in the parameter there.
  [[nodiscard]] double distance_to_fold() const;
};

/// The pair of a set nearest to two predicted places, each within `tolerance`.
[[nodiscard]] std::optional<ConfigurationPair> pair_near(const SnapshotPointer& set,
                                                         const Eigen::VectorXd& one,
                                                         const Eigen::VectorXd& other,
                                                         double tolerance);

/// The same pair at another value of the parameter: its middle moves smoothly, and its separation
/// is multiplied by `shrink`. Returns nothing if that is not positive, or if no pair is found
/// there.
[[nodiscard]] std::optional<ConfigurationPair> pair_followed(SnapshotSolver& solver,
                                                             const ConfigurationPair& pair,
                                                             double parameter, double shrink);

/// Follows a pair to the fold where it meets. Along the branch through a fold both the parameter
/// and the configuration are analytic in g = dp / d(v . X), where v is the direction between the
/// two; each configuration near the fold gives one exact g, and the fold is at g = 0. `through`
/// says that a third branch passes there, so that the Jacobian loses digits sooner.
[[nodiscard]] std::optional<EventLocation> locate_fold(SnapshotSolver& solver,
                                                       const ConfigurationPair& near, bool through);

/// Locates the same fold from the nearest pair that rounding allows, and wider ones, with g = dp /
/// d(v . (X - M)), where M is the middle of each pair.
[[nodiscard]] std::optional<EventLocation> locate_fold_from(SnapshotSolver& solver,
                                                            const ConfigurationPair& near);

}  // namespace assur::mechanism::follow
