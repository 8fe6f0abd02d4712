// Covariance of all parameters, from the entries of a request.
#pragma once

#include <assur/mechanism/request.hpp>
#include <assur/mechanism/values.hpp>

namespace assur::mechanism::values {

/// The covariance C of all parameters: the given matrix for the parameters that it names, zero
/// elsewhere. Throws MechanismError unless the matrix is symmetric (|c_ij - c_ji| <= t sqrt(c_ii
/// c_jj)), each covariance is within the bound of its variances (|c_ij| <= (1 + t) sqrt(c_ii c_jj))
/// and the correlations c_ij / sqrt(c_ii c_jj) have no eigenvalue below -n t, with t = 1e-12 for
/// the roundings of expressions.
[[nodiscard]] Eigen::MatrixXd covariance_matrix(const Covariance& given, const Values& values,
                                                std::size_t parameter_count);

}  // namespace assur::mechanism::values
