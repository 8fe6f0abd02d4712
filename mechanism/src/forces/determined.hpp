// The solution of linear equations that may be singular, and which of its parts they determine.
#pragma once

#include <Eigen/QR>

namespace assur::mechanism::forces {

/// M x = b. Where M lacks rank, the solution is the shortest of those that satisfy the equations
/// best, and an unknown that a vector of the null space of M moves is not determined: beside such
/// a matrix, it grows without bound.
class LinearEquations {
 public:
  /// Directions that M shortens to less than this part of its largest factor count as null.
  LinearEquations(const Eigen::MatrixXd& matrix, double threshold);

  [[nodiscard]] bool determine_all() const { return movable_.size() == 0; }
  [[nodiscard]] bool determine(Eigen::Index unknown) const {
    return determine_all() || !(movable_(unknown) > response);
  }
  /// The solution for each column of b; NaN where an unknown is not determined, or where it depends
  /// on an entry of b that is not finite.
  [[nodiscard]] Eigen::MatrixXd solve(Eigen::MatrixXd rhs) const;
  /// One solution, also of the unknowns that are not determined, where the equations have one for
  /// every b; otherwise the same as `solve`.
  [[nodiscard]] Eigen::MatrixXd some_solution(const Eigen::MatrixXd& rhs) const;

  /// The least part of a unit vector of the null space that counts as a response to it. The space
  /// is known to within rounding divided by the threshold of rank, 1e-9.
  static constexpr double response = 1e-7;

 private:
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors_;
  Eigen::VectorXd
      movable_;  ///< the size of each unknown's row of the null space; empty without one
};

}  // namespace assur::mechanism::forces
