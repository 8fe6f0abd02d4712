#include "scene/covariance.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdio>

#include "error.hpp"

namespace assur::generator {

namespace {

// The entries come from the scene's expressions, a few roundings each.
constexpr double tolerance = 1e-12;

std::string shown(double number) {
  std::array<char, 32> text{};
  (void)std::snprintf(text.data(), text.size(), "%.6g", number);
  return text.data();
}

std::string entry(Eigen::Index row, Eigen::Index column) {
  return "covariance.matrix[" + std::to_string(row) + "][" + std::to_string(column) + "]";
}

/// The correlations of a matrix with finite entries; throws unless it is symmetric, and its
/// variances and each pair of them allow its entries. A variance of zero correlates with nothing.
Eigen::MatrixXd correlations(const Eigen::MatrixXd& matrix, const std::string& file) {
  const auto fail = [&](const std::string& where, const std::string& what) {
    throw InputError(file + ": " + where + ": " + what);
  };
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    if (matrix(row, row) < 0) {
      fail(entry(row, row), "a variance cannot be negative");
    }
  }
  const Eigen::VectorXd deviations = matrix.diagonal().cwiseSqrt();
  Eigen::MatrixXd result = Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols());
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      const double limit = deviations(i) * deviations(j);
      if (!(std::abs(matrix(i, j) - matrix(j, i)) <= tolerance * limit)) {
        fail(entry(i, j), "the matrix is not symmetric: " + shown(matrix(i, j)) + " here, " +
                              shown(matrix(j, i)) + " in [" + std::to_string(j) + "][" +
                              std::to_string(i) + "]");
      }
      if (!(std::abs(matrix(i, j)) <= (1 + tolerance) * limit)) {
        fail(entry(i, j), "a covariance of " + shown(matrix(i, j)) +
                              " is more than its variances allow (at most " + shown(limit) +
                              ", the root of their product)");
      }
      if (limit > 0) {
        result(i, j) = result(j, i) = matrix(i, j) / limit;
      }
    }
  }
  return result;
}

}  // namespace

Eigen::MatrixXd covariance_matrix(const Scene& scene, const ParameterValues& values) {
  const SceneCovariance& given = *scene.covariance;
  const auto size = static_cast<Eigen::Index>(given.parameters.size());
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index row = 0; row < size; ++row) {
    for (Eigen::Index column = 0; column < size; ++column) {
      const auto& numbers = given.matrix[static_cast<std::size_t>(row)];
      matrix(row, column) = values.value(numbers[static_cast<std::size_t>(column)]).value();
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(correlations(matrix, scene.file),
                                                              Eigen::EigenvaluesOnly);
  const double smallest = solver.eigenvalues().minCoeff();
  if (smallest < -static_cast<double>(size) * tolerance) {
    throw InputError(scene.file +
                     ": covariance.matrix: not positive semi-definite, so no parameters vary so: "
                     "the matrix of correlations has the eigenvalue " +
                     shown(smallest));
  }
  const Eigen::MatrixXd symmetric = (matrix + matrix.transpose()) / 2;
  const Eigen::Index count = values.count();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(count, count);
  result(given.parameters, given.parameters) = symmetric;
  return result;
}

PointSpread spread_of(const PointState& point, const Eigen::MatrixXd& covariance) {
  Eigen::Matrix<double, 2, Eigen::Dynamic> sensitivity(2, covariance.cols());
  sensitivity.row(0) = point.x.derivatives().transpose();
  sensitivity.row(1) = point.y.derivatives().transpose();
  PointSpread spread;
  const Eigen::Matrix2d product = sensitivity * covariance * sensitivity.transpose();
  spread.covariance = (product + product.transpose()) / 2;  // symmetric to the last digit
  spread.mean_shift = {0.5 * covariance.cwiseProduct(point.x.hessian()).sum(),
                       0.5 * covariance.cwiseProduct(point.y.hessian()).sum()};
  return spread;
}

}  // namespace assur::generator
