#include "covariance.hpp"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <cstdio>

namespace assur::mechanism::values {

namespace {

// The entries result from the scene's expressions, with a few roundings each.
constexpr double entry_rounding = 1e-12;

std::string shown(double number) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.6g", number);
  return text.data();
}

std::string entry(Eigen::Index row, Eigen::Index column) {
  return "covariance.matrix[" + std::to_string(row) + "][" + std::to_string(column) + "]";
}

/// The correlations of a matrix with finite entries; throws unless it is symmetric and its
/// variances are not negative and bound its entries. A zero variance has zero correlations.
Eigen::MatrixXd correlations(const Eigen::MatrixXd& matrix) {
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    if (matrix(row, row) < 0) {
      throw MechanismError(entry(row, row), "a variance cannot be negative");
    }
  }
  const Eigen::VectorXd deviations = matrix.diagonal().cwiseSqrt();
  Eigen::MatrixXd result = Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols());
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      const double limit = deviations(i) * deviations(j);
      if (!(std::abs(matrix(i, j) - matrix(j, i)) <= entry_rounding * limit)) {
        throw MechanismError(entry(i, j), "the matrix is not symmetric: " + shown(matrix(i, j)) +
                                              " here, " + shown(matrix(j, i)) + " in [" +
                                              std::to_string(j) + "][" + std::to_string(i) + "]");
      }
      if (!(std::abs(matrix(i, j)) <= (1 + entry_rounding) * limit)) {
        throw MechanismError(entry(i, j), "a covariance of " + shown(matrix(i, j)) +
                                              " is more than its variances allow (at most " +
                                              shown(limit) + ", the root of their product)");
      }
      if (limit > 0) {
        result(i, j) = result(j, i) = matrix(i, j) / limit;
      }
    }
  }
  return result;
}

/// Whether all eigenvalues are at least -`slack`, tested by a Cholesky factorisation of the matrix
/// with the slack on its diagonal.
bool is_semi_definite(const Eigen::MatrixXd& symmetric, double slack) {
  const Eigen::MatrixXd raised =
      symmetric + slack * Eigen::MatrixXd::Identity(symmetric.rows(), symmetric.cols());
  return Eigen::LLT<Eigen::MatrixXd>(raised).info() == Eigen::Success;
}

/// The smallest eigenvalue of a symmetric matrix, for a message: by bisection.
double smallest_eigenvalue(const Eigen::MatrixXd& symmetric) {
  double low = -symmetric.cwiseAbs().rowwise().sum().maxCoeff();
  double high = 0;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (low + high) / 2;
    (is_semi_definite(symmetric, -middle) ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

Eigen::MatrixXd covariance_matrix(const Covariance& given, const Values& values,
                                  std::size_t parameter_count) {
  const std::size_t size = given.parameters.size();
  Eigen::MatrixXd matrix(size, size);
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < size; ++column) {
      matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
          values.number(given.matrix[row][column]).value();
    }
  }
  const Eigen::MatrixXd related = correlations(matrix);
  if (!is_semi_definite(related, static_cast<double>(size) * entry_rounding)) {
    throw MechanismError("covariance.matrix",
                         "no parameters can vary like this: the matrix is not positive "
                         "semi-definite, since the matrix of correlations has the eigenvalue " +
                             shown(smallest_eigenvalue(related)));
  }
  const auto count = static_cast<Eigen::Index>(parameter_count);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(count, count);
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < size; ++column) {
      const auto i = static_cast<Eigen::Index>(row);
      const auto j = static_cast<Eigen::Index>(column);
      result(given.parameters[row].row(), given.parameters[column].row()) =
          (matrix(i, j) + matrix(j, i)) / 2;
    }
  }
  return result;
}

}  // namespace assur::mechanism::values
