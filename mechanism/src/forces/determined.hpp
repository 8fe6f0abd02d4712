// Solution of linear equations that may be singular, and the unknowns that they determine.
#pragma once

#include <Eigen/QR>

namespace assur::mechanism::forces {

/// The shortest solution of linear equations and, if the matrix lacks rank, an orthonormal basis of
/// its null space, as columns. A sum of unknowns is determined if no vector of the null space
/// changes it.
struct LinearSolution {
  Eigen::VectorXd shortest;
  Eigen::MatrixXd null_space;
  /// The least part of a unit vector of the null space that counts as nonzero: the space is known
  /// to within rounding divided by the least singular value that is not null.
  double response = 0;

  [[nodiscard]] bool determines(Eigen::Index unknown) const {
    return !(null_space.row(unknown).norm() > response);
  }
};

/// M x = b. Unknowns that are not determined grow without bound for matrices near M. Equations with
/// an infinite or unknown b are left out. If no x satisfies the equations, or none does for some
/// values of unknown b, those of such unknowns are left out, too: their results depend on the
/// matrices near M.
class LinearEquations {
 public:
  /// The rows or columns that belong in threes to links; nearby matrices may have nonzero entries
  /// there.
  enum class OfLinks : unsigned char { rows, columns };

  /// Directions that M shortens to less than this part of its largest pivot count as null.
  LinearEquations(const Eigen::MatrixXd& matrix, double threshold, OfLinks of_links);

  [[nodiscard]] LinearSolution solution(const Eigen::VectorXd& rhs) const;
  /// What is left of equations, and changes of unknowns, that count as zero where directions are
  /// shortened to the threshold of rank, 1e-9: rounding divided by it.
  static constexpr double negligible = 1e-7;

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
  double response_ = 0;  ///< see `LinearSolution`
};

}  // namespace assur::mechanism::forces
