// Turns parameters, and links that move along a branch, into the motions of features on their links
// and of drivers.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>
#include <functional>
#include <vector>

#include "models/series.hpp"

namespace assur::mechanism::solve {

/// The angle between the links of a revolute joint without a driver, as they move along a branch
/// through a configuration; it includes the whole turns that the configuration counts.
[[nodiscard]] models::Series moving_angle(const Table<LinkIndex, Pose<models::Series>>& links,
                                          const Configuration& configuration, JointIndex index);

/// A feature on its link, whose coordinates move as the parameters in them do. The third and fourth
/// orders of parameters are zero.
[[nodiscard]] LinkFeature<models::Series> moving_feature(const Values& values, FeatureIndex index,
                                                         bool is_line);

/// The value of a law that reads coordinates of joints, as a series. Rates that the driver states
/// replace those that follow from the law; then the third and fourth orders are zero, as those of
/// parameters are.
[[nodiscard]] models::Series moving_law(
    const Values& values, DriverIndex index,
    const std::function<models::Series(JointIndex)>& coordinate_of);

}  // namespace assur::mechanism::solve
