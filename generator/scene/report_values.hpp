// Turns a solution's states into the words and derived numbers that every report shows.
#pragma once

#include "scene/solve.hpp"

namespace assur::generator {

[[nodiscard]] const char* status_text(SolutionStatus status);
[[nodiscard]] const char* regularity_text(Status regularity);

/// In (-pi, pi].
[[nodiscard]] double angle(const Direction<Dual>& direction);

/// Sum of |derivative| x tolerance.
[[nodiscard]] double worst_case(const Dual& coordinate, const Eigen::VectorXd& tolerances);
/// Root of the sum of (derivative x tolerance)^2.
[[nodiscard]] double root_sum_square(const Dual& coordinate, const Eigen::VectorXd& tolerances);

/// A point's acceleration in parts along its path and across it; both NaN where v = 0, for a point
/// at rest has no direction of travel.
struct PathAcceleration {
  double tangential;  ///< a . v / |v|, positive where the speed grows
  double normal;      ///< (v x a) / |v|, positive where the path bends to the left
};
[[nodiscard]] PathAcceleration path_acceleration(const PointState& point);

}  // namespace assur::generator
