// Location of the parameter value at which a configuration runs to infinity.
#pragma once

#include <optional>

#include "event_location.hpp"
#include "snapshot_solver.hpp"

namespace assur::mechanism::follow {

/// The value at which a configuration of a set runs to infinity: the zero of 1 / (w . X), where w
/// is its direction.
[[nodiscard]] std::optional<EventLocation> locate_escape(SnapshotSolver& solver,
                                                         const SnapshotPointer& near,
                                                         PointIndex index);
/// A first estimate of the same zero, as its parameter distance from a point.
[[nodiscard]] double distance_to_escape(const ConfigurationPoint& point);

}  // namespace assur::mechanism::follow
