// Tolerances, spread and path acceleration of a point.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>

namespace assur::mechanism {

/// The worst case of each coordinate, the sum of |derivative| x tolerance. The point must have a
/// derivative for every parameter.
[[nodiscard]] Eigen::Vector2d worst_case(const Point& point, const Spread& spread);
/// For each coordinate the root of the sum of (derivative x tolerance)^2.
[[nodiscard]] Eigen::Vector2d root_sum_square(const Point& point, const Spread& spread);

/// The variation of a point about its nominal position p for parameters with a covariance C.
struct PointSpread {
  Eigen::Matrix2d covariance;  ///< S C S^T, S = dp/da
  Eigen::Vector2d mean_shift;  ///< E[p] - p to second order: 1/2 sum_ij C_ij d2p/da_i da_j
};

/// The spread of a point, which must carry second derivatives.
[[nodiscard]] PointSpread spread_of(const Point& point, const Spread& spread);

/// The components of a point's acceleration along its path and across it; both NaN for v = 0, since
/// a point at rest has no direction of travel.
struct PathAcceleration {
  double tangential;  ///< a . v / |v|, positive where the speed grows
  double normal;      ///< (v x a) / |v|, positive where the path bends to the left
};
[[nodiscard]] PathAcceleration path_acceleration(const Point& point);

}  // namespace assur::mechanism
