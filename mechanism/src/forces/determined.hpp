// Solution of linear equations that may be singular, and the unknowns that they determine.
#pragma once

#include <Eigen/QR>

namespace assur::mechanism::forces {

/// The shortest solution of linear equations, and as columns what may be added to it: an
/// orthonormal basis of the matrix's null space, and the solutions for a unit of each unknown
/// right-hand side. A sum of unknowns is determined if none of them changes it.
struct LinearSolution {
  Eigen::VectorXd shortest;
  Eigen::MatrixXd null_space;

  /// The least change that counts as nonzero. The space is known to within rounding divided by the
  /// threshold of rank, 1e-9.
  static constexpr double response = 1e-7;

  [[nodiscard]] bool determines(Eigen::Index unknown) const {
    return !(null_space.row(unknown).norm() > response);
  }
};

/// M x = b. Unknowns that are not determined grow without bound for matrices near M. If no x
/// satisfies the equations, or none does for some values of infinite or unknown b, those of such
/// unknowns are left out: their results depend on the matrices near M.
class LinearEquations {
 public:
  /// The rows or columns that belong in threes to links; nearby matrices may have nonzero entries
  /// there.
  enum class OfLinks : unsigned char { rows, columns };

  /// Directions that M shortens to less than this part of its largest pivot count as null.
  LinearEquations(const Eigen::MatrixXd& matrix, double threshold, OfLinks of_links);

  [[nodiscard]] LinearSolution solution(const Eigen::VectorXd& rhs) const;
  /// The solution for each column of b; NaN where an unknown is not determined.
  [[nodiscard]] Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) const;
  /// One solution, including unknowns that are not determined, if the equations have one for every
  /// b; otherwise the same as `solve`.
  [[nodiscard]] Eigen::MatrixXd some_solution(const Eigen::MatrixXd& rhs) const;

 private:
  using Equations = Eigen::Array<bool, Eigen::Dynamic, 1>;

  /// The solution without some of the equations.
  [[nodiscard]] LinearSolution solution_without(const Equations& left_out,
                                                const Eigen::VectorXd& rhs) const;
  [[nodiscard]] Equations equations_of_movable() const;
  /// Whether there is a solution whatever the right-hand sides of some equations are.
  [[nodiscard]] bool have_solution_for_all(const Equations& unknown) const;
  /// Whether an equation contains, or for matrices near M may contain, an unknown that the null
  /// space changes.
  [[nodiscard]] bool has_movable(Eigen::Index row) const;

  Eigen::MatrixXd matrix_;
  double threshold_;
  OfLinks of_links_;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors_;
  Eigen::MatrixXd null_space_;
};

}  // namespace assur::mechanism::forces
