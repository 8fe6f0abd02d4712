// Turns the motions of drivers into every motion of the groups behind them.
#pragma once

#include <optional>
#include <vector>

#include "group_solver.hpp"
#include "models/series.hpp"

namespace assur::mechanism::solve {

/// How far each driver moves, from where it is, and whether links change their shapes meanwhile.
struct Motions {
  Table<DriverIndex, models::Series> drivers;
  bool in_time;
};

/// The motions that go through a configuration, each as that configuration with its velocities and
/// accelerations: its groups are walked through depth first, as solving walks through their
/// configurations. A law that reads where links are moves its driver as they do on each motion.
/// Nothing where it is not known how a driver moves, or how one changes the shape of a group.
[[nodiscard]] std::optional<std::vector<Configuration>> motions_through(
    const Values& values, const PlacedLinks& placed, const Configuration& configuration,
    const Motions& motions);

}  // namespace assur::mechanism::solve
