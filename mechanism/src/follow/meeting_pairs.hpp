// Pairs of unmatched configurations that meet within an interval.
#pragma once

#include <utility>
#include <vector>

#include "fold_location.hpp"

namespace assur::mechanism::follow {

/// One side of an interval, with configurations to examine, and its other end.
struct Side {
  SnapshotPointer near;
  double end;
  bool is_left;

  [[nodiscard]] double reach() const { return end - near->parameter; }
  /// Whether an estimate lies within the interval. It may overshoot slightly; the located value may
  /// not.
  [[nodiscard]] bool reaches(double distance, double slack) const {
    const double part = distance / reach();
    return part > 0 && part < 1 + slack;
  }
};

/// The pair that meets next: the closest of those that run head-on, or else the closest of all.
/// Where several pairs meet in one configuration, the closest two may belong to different ones.
[[nodiscard]] std::pair<PointIndex, PointIndex> meeting(const Side& side,
                                                        const std::vector<PointIndex>& among);

/// Whether no other configuration is near the pair or its predicted meeting place. Two exceptions
/// are allowed: one configuration right between the two, which becomes `through`, and those among
/// `alone` that meet in the same place.
[[nodiscard]] bool is_apart_from_others(const ConfigurationPair& pair, double distance,
                                        const std::vector<PointIndex>& alone, PointIndex& through);

}  // namespace assur::mechanism::follow
