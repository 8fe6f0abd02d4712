// Turns the motions of drivers into every motion of the groups behind them.
#pragma once

#include <optional>
#include <vector>

#include "group_solver.hpp"
#include "models/series.hpp"

namespace assur::mechanism::solve {

/// How far each driver moves from where it is, as a series, and whether the series are in time, so
/// that links may change their shapes meanwhile.
struct Motions {
  Table<DriverIndex, models::Series> drivers;
  bool in_time;
};

/// The motions that go through a configuration, each as that configuration with its velocities and
/// accelerations. Its groups are walked through depth first, as solving walks through their
/// configurations. A driver whose law reads joints moves as they do on each motion. Returns nothing
/// where the motion of a driver, or the change of a group's shape, is not known.
[[nodiscard]] std::optional<std::vector<Configuration>> motions_through(
    const Values& values, const PlacedLinks& placed, const Configuration& configuration,
    const Motions& motions);

}  // namespace assur::mechanism::solve
