// Motions of features and of drivers' laws as power series along a branch.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>
#include <functional>
#include <vector>

#include "models/series.hpp"

namespace assur::mechanism::solve {

/// The angle between the links of a revolute joint without a driver, along a branch through a
/// configuration; it includes the whole turns that the configuration counts.
[[nodiscard]] models::Series moving_angle(const Table<LinkIndex, Pose<models::Series>>& links,
                                          const Configuration& configuration, JointIndex index);

/// A feature on its link, with coordinates that follow the motion of the parameters. The third and
/// fourth orders of parameters are zero.
[[nodiscard]] LinkFeature<models::Series> moving_feature(const Values& values, FeatureIndex index,
                                                         bool is_line);

/// The value of a law that reads coordinates of joints, as a series. Rates stated by the driver
/// replace those of the law; then the third and fourth orders are zero, as those of parameters are.
[[nodiscard]] models::Series moving_law(
    const Values& values, DriverIndex index,
    const std::function<models::Series(JointIndex)>& coordinate_of);

}  // namespace assur::mechanism::solve
