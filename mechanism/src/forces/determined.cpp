#include "determined.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <limits>

namespace assur::mechanism::forces {

LinearEquations::LinearEquations(const Eigen::MatrixXd& matrix, double threshold) {
  factors_.setThreshold(threshold);
  factors_.compute(matrix);
  if (factors_.rank() < matrix.cols()) {
    Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullV);
    movable_ = svd.matrixV().rightCols(matrix.cols() - factors_.rank()).rowwise().norm();
  }
}

Eigen::MatrixXd LinearEquations::solve(Eigen::MatrixXd rhs) const {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  Eigen::MatrixXd lost = Eigen::MatrixXd::Zero(factors_.cols(), rhs.cols());
  for (Eigen::Index row = 0; row < rhs.rows(); ++row) {
    if (rhs.row(row).allFinite()) {
      continue;
    }
    const Eigen::VectorXd follows = factors_.solve(Eigen::VectorXd::Unit(rhs.rows(), row));
    for (Eigen::Index column = 0; column < rhs.cols(); ++column) {
      if (!std::isfinite(rhs(row, column))) {
        lost.col(column) += follows.cwiseAbs();
        rhs(row, column) = 0;
      }
    }
  }
  Eigen::MatrixXd result = factors_.solve(rhs);
  for (Eigen::Index row = 0; row < result.rows(); ++row) {
    for (Eigen::Index column = 0; column < result.cols(); ++column) {
      if (!determine(row) || lost(row, column) > response) {
        result(row, column) = unknown;
      }
    }
  }
  return result;
}

Eigen::MatrixXd LinearEquations::some_solution(const Eigen::MatrixXd& rhs) const {
  return factors_.rank() == factors_.rows() && rhs.allFinite()
             ? Eigen::MatrixXd(factors_.solve(rhs))
             : solve(rhs);
}

}  // namespace assur::mechanism::forces
