// Turns links that move along a branch into the motions of drivers whose laws read their joints.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>
#include <functional>
#include <vector>

#include "models/series.hpp"

namespace assur::mechanism::solve {

/// The displacement of a slide that a group has placed, as far as it moves.
struct MovingSlide {
  JointIndex joint;
  models::Series moved;
};

/// What a branch has placed so far, and the configuration through which it goes.
struct MovingParts {
  const Table<LinkIndex, Pose<models::Series>>& links;
  const std::vector<MovingSlide>& slides;
  const Configuration& configuration;
};

/// The coordinate of a joint without a driver, between links that move; an angle counts whole turns
/// as the configuration does.
[[nodiscard]] models::Series moving_coordinate(const MovingParts& parts, JointIndex joint);

/// What a law says that reads coordinates of joints, as it moves. Rates that the driver states are
/// its own; what they leave open of third and fourth order is zero, as that of parameters is.
[[nodiscard]] models::Series moving_law(
    const Values& values, DriverIndex driver,
    const std::function<models::Series(JointIndex)>& coordinate_of);

}  // namespace assur::mechanism::solve
