#include "determined.hpp"

#include <Eigen/SVD>
#include <limits>

namespace assur::mechanism::forces {

LinearEquations::LinearEquations(const Eigen::MatrixXd& matrix, double threshold, OfLinks of_links)
    : matrix_(matrix), threshold_(threshold), of_links_(of_links), null_space_(matrix.cols(), 0) {
  factors_.setThreshold(threshold);
  factors_.compute(matrix);
  if (factors_.rank() < matrix.cols()) {
    Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullV);
    null_space_ = svd.matrixV().rightCols(matrix.cols() - factors_.rank());
  }
}

bool LinearEquations::has_movable(Eigen::Index row) const {
  const bool are_rows = of_links_ == OfLinks::rows;
  const Eigen::Index first = are_rows ? row - row % 3 : row;
  const auto equations = matrix_.middleRows(first, are_rows ? 3 : 1).cwiseAbs();
  const LinearSolution of_matrix{{}, null_space_};
  for (Eigen::Index column = 0; column < matrix_.cols(); ++column) {
    const Eigen::Index begin = are_rows ? column : column - column % 3;
    const Eigen::Index count = are_rows ? 1 : 3;
    if (!of_matrix.determines(column) &&
        equations.middleCols(begin, count).maxCoeff() > LinearSolution::response) {
      return true;
    }
  }
  return false;
}

LinearEquations::Equations LinearEquations::equations_of_movable() const {
  Equations result(matrix_.rows());
  for (Eigen::Index row = 0; row < matrix_.rows(); ++row) {
    result(row) = has_movable(row);
  }
  return result;
}

bool LinearEquations::have_solution_for_all(const Equations& unknown) const {
  for (Eigen::Index row = 0; row < matrix_.rows(); ++row) {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(matrix_.rows(), row);
    if (unknown(row) && (matrix_ * factors_.solve(unit) - unit).norm() > LinearSolution::response) {
      return false;
    }
  }
  return true;
}

LinearSolution LinearEquations::solution_without(const Equations& left_out,
                                                 const Eigen::VectorXd& rhs) const {
  Eigen::MatrixXd rest = matrix_;
  Eigen::VectorXd rest_of_rhs = rhs;
  for (Eigen::Index row = 0; row < rest.rows(); ++row) {
    if (left_out(row)) {
      rest.row(row).setZero();
      rest_of_rhs(row) = 0;
    }
  }
  return LinearEquations(rest, threshold_, of_links_).solution(rest_of_rhs);
}

LinearSolution LinearEquations::solution(const Eigen::VectorXd& rhs) const {
  const Equations unknown = !rhs.array().isFinite();
  if (unknown.any() && of_links_ == OfLinks::columns) {  // the other equations may determine all
    return solution_without(unknown, rhs);
  }
  const Eigen::VectorXd known = unknown.select(0, rhs);
  LinearSolution result{factors_.solve(known), null_space_};
  const bool is_solved =
      (matrix_ * result.shortest - known).norm() <= LinearSolution::response * known.norm() &&
      have_solution_for_all(unknown);
  if (null_space_.cols() > 0 && !is_solved) {
    if (const Equations left_out = equations_of_movable(); left_out.any()) {
      return solution_without(left_out, rhs);
    }
  }
  for (Eigen::Index row = 0; row < rhs.size(); ++row) {
    if (unknown(row)) {
      result.null_space.conservativeResize(Eigen::NoChange, result.null_space.cols() + 1);
      result.null_space.rightCols(1) = factors_.solve(Eigen::VectorXd::Unit(matrix_.rows(), row));
    }
  }
  return result;
}

Eigen::MatrixXd LinearEquations::solve(const Eigen::MatrixXd& rhs) const {
  Eigen::MatrixXd result(matrix_.cols(), rhs.cols());
  for (Eigen::Index column = 0; column < rhs.cols(); ++column) {
    const LinearSolution solved = solution(rhs.col(column));
    for (Eigen::Index unknown = 0; unknown < result.rows(); ++unknown) {
      result(unknown, column) = solved.determines(unknown)
                                    ? solved.shortest(unknown)
                                    : std::numeric_limits<double>::quiet_NaN();
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
