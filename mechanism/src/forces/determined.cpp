#include "determined.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <limits>

namespace assur::mechanism::forces {

LinearEquations::LinearEquations(const Eigen::MatrixXd& matrix, double threshold, OfLinks of_links)
    : matrix_(matrix), threshold_(threshold), of_links_(of_links) {
  factors_.setThreshold(threshold);
  factors_.compute(matrix);
  if (factors_.rank() < matrix.cols()) {
    Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullV);
    movable_ = svd.matrixV().rightCols(matrix.cols() - factors_.rank()).rowwise().norm();
  }
}

bool LinearEquations::has_movable(Eigen::Index row) const {
  const bool are_rows = of_links_ == OfLinks::rows;
  const Eigen::Index first = are_rows ? row - row % 3 : row;
  const auto equations = matrix_.middleRows(first, are_rows ? 3 : 1).cwiseAbs();
  for (Eigen::Index column = 0; column < matrix_.cols(); ++column) {
    const Eigen::Index begin = are_rows ? column : column - column % 3;
    const Eigen::Index count = are_rows ? 1 : 3;
    if (!determine(column) && equations.middleCols(begin, count).maxCoeff() > response) {
      return true;
    }
  }
  return false;
}

Eigen::VectorXd LinearEquations::solve_without(const Equations& left_out,
                                               const Eigen::VectorXd& rhs) const {
  Eigen::MatrixXd rest = matrix_;
  Eigen::VectorXd rest_of_rhs = rhs;
  for (Eigen::Index row = 0; row < rest.rows(); ++row) {
    if (left_out(row)) {
      rest.row(row).setZero();
      rest_of_rhs(row) = 0;
    }
  }
  return LinearEquations(rest, threshold_, of_links_).solve_column(rest_of_rhs);
}

Eigen::VectorXd LinearEquations::solve_column(const Eigen::VectorXd& rhs) const {
  if (!rhs.allFinite()) {
    return solve_without(!rhs.array().isFinite(), rhs);
  }
  Eigen::VectorXd result = factors_.solve(rhs);
  if (determine_all()) {
    return result;
  }
  if ((matrix_ * result - rhs).norm() > response * rhs.norm()) {
    Equations left_out(matrix_.rows());
    for (Eigen::Index row = 0; row < matrix_.rows(); ++row) {
      left_out(row) = has_movable(row);
    }
    if (left_out.any()) {
      return solve_without(left_out, rhs);
    }
  }
  for (Eigen::Index unknown = 0; unknown < result.size(); ++unknown) {
    if (!determine(unknown)) {
      result(unknown) = std::numeric_limits<double>::quiet_NaN();
    }
  }
  return result;
}

Eigen::MatrixXd LinearEquations::solve(const Eigen::MatrixXd& rhs) const {
  Eigen::MatrixXd result(matrix_.cols(), rhs.cols());
  for (Eigen::Index column = 0; column < rhs.cols(); ++column) {
    result.col(column) = solve_column(rhs.col(column));
  }
  return result;
}

Eigen::MatrixXd LinearEquations::some_solution(const Eigen::MatrixXd& rhs) const {
  return factors_.rank() == factors_.rows() && rhs.allFinite()
             ? Eigen::MatrixXd(factors_.solve(rhs))
             : solve(rhs);
}

}  // namespace assur::mechanism::forces
