// Turns the covariance of a scene's parameters into that of its points.
#pragma once

#include "scene/link_state.hpp"

namespace assur::generator {

/// The covariance C of all parameters of a scene that has one: what the scene's matrix says of the
/// parameters that it names, zero elsewhere. Throws InputError unless the matrix is symmetric
/// (|c_ij - c_ji| <= t sqrt(c_ii c_jj)), no covariance exceeds what its variances allow
/// (|c_ij| <= (1 + t) sqrt(c_ii c_jj)) and the correlations c_ij / sqrt(c_ii c_jj) have no
/// eigenvalue below -n t, with t = 1e-12 for the roundings of expressions.
[[nodiscard]] Eigen::MatrixXd covariance_matrix(const Scene& scene, const ParameterValues& values);

/// How a point varies about its nominal position p while the parameters vary with a covariance C.
struct PointSpread {
  Eigen::Matrix2d covariance;  ///< S C S^T, S = dp/da
  Eigen::Vector2d mean_shift;  ///< E[p] - p to second order: 1/2 sum_ij C_ij d2p/da_i da_j
};

/// The point's coordinates must carry Hessians.
[[nodiscard]] PointSpread spread_of(const PointState& point, const Eigen::MatrixXd& covariance);

}  // namespace assur::generator
