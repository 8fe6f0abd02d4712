// Turns the motions of drivers into every motion of the groups behind them.
#pragma once

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
/// configurations.
[[nodiscard]] std::vector<Configuration> motions_through(const Values& values,
                                                         const PlacedLinks& placed,
                                                         const Configuration& configuration,
                                                         const Motions& motions);

}  // namespace assur::mechanism::solve
