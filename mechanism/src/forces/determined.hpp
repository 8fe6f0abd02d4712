// Solution of linear equations that may be singular, and the unknowns that they determine.
#pragma once

#include <Eigen/QR>

namespace assur::mechanism::forces {

/// M x = b. If M lacks rank, the solution is the shortest, and an unknown that a vector of the null
/// space changes is not determined: for matrices near M it grows without bound. Equations with an
/// infinite or unknown b are left out. If no x satisfies the equations, those of such unknowns are
/// left out, too: their results depend on the matrices near M.
class LinearEquations {
 public:
  /// The rows or columns that belong in threes to links; nearby matrices may have nonzero entries
  /// there.
  enum class OfLinks : unsigned char { rows, columns };

  /// Directions that M shortens to less than this part of its largest pivot count as null.
  LinearEquations(const Eigen::MatrixXd& matrix, double threshold, OfLinks of_links);

  [[nodiscard]] bool determine_all() const { return movable_.size() == 0; }
  [[nodiscard]] bool determine(Eigen::Index unknown) const {
    return determine_all() || !(movable_(unknown) > response);
  }
  /// The solution for each column of b; NaN where an unknown is not determined.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) const;
  /// One solution, including unknowns that are not determined, if the equations have one for every
  /// b; otherwise the same as `solve`.
  [[nodiscard]] Eigen::MatrixXd some_solution(const Eigen::MatrixXd& rhs) const;

  /// The least component of a unit vector of the null space that counts as nonzero. The space is
  /// known to within rounding divided by the threshold of rank, 1e-9.
  static constexpr double response = 1e-7;

 private:
  using Equations = Eigen::Array<bool, Eigen::Dynamic, 1>;

  [[nodiscard]] Eigen::VectorXd solve_column(const Eigen::VectorXd& rhs) const;
  /// The solution without some of the equations.
  [[nodiscard]] Eigen::VectorXd solve_without(const Equations& left_out,
                                              const Eigen::VectorXd& rhs) const;
  /// Whether an equation contains, or for matrices near M may contain, an unknown that the null
  /// space changes.
  [[nodiscard]] bool has_movable(Eigen::Index row) const;

  Eigen::MatrixXd matrix_;
  double threshold_;
  OfLinks of_links_;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors_;
  Eigen::VectorXd
      movable_;  ///< the size of each unknown's row of the null space; empty without one
};

}  // namespace assur::mechanism::forces
