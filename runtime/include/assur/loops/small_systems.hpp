// Linear systems of a group. Their code is the same for all sizes, since decompositions of matrices
// of each size would take minutes to compile.
#pragma once

#include <Eigen/Core>
#include <assur/local/elimination.hpp>
#include <assur/loops/loop_equations.hpp>
#include <limits>

namespace assur::loops {

/// A matrix whose first columns can be eliminated; initially zero. The bounds of rows and columns
/// may be Eigen::Dynamic.
template <typename Scalar, int MostRows, int MostColumns>
class SmallSystem {
 public:
  SmallSystem(Eigen::Index rows, Eigen::Index columns)
      : table_(memory_, static_cast<int>(rows), static_cast<int>(columns)) {}

  template <typename Matrix>
  void put(Eigen::Index first_column, const Eigen::MatrixBase<Matrix>& matrix) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
      for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
        entry(row, first_column + column) = matrix(row, column);
      }
    }
  }
  /// Eliminates `rank` of the first columns; returns the ratio of the last pivot to the first.
  [[nodiscard]] double eliminate(Eigen::Index columns, Eigen::Index rank) {
    return local::eliminate(table_, static_cast<int>(columns), static_cast<int>(rank), pivots_);
  }
  /// Eliminates columns as long as pivots exceed a fraction of the first one; returns their number.
  [[nodiscard]] Eigen::Index eliminate_above(double part, Eigen::Index columns) {
    pivots_.begin(table_.rows(), static_cast<int>(columns));
    double first = 0;
    Eigen::Index rank = 0;
    for (; rank < columns; ++rank) {
      const double pivot =
          local::eliminate_largest(table_, static_cast<int>(columns), part * first, pivots_);
      if (pivot == 0) {
        break;
      }
      first = rank == 0 ? pivot : first;
    }
    return rank;
  }
  /// The pivot row of a column; -1 if there is none.
  [[nodiscard]] int row_of(Eigen::Index column) const {
    return pivots_.row_of(static_cast<int>(column));
  }
  [[nodiscard]] Scalar& entry(Eigen::Index row, Eigen::Index column) {
    return table_(static_cast<int>(row), static_cast<int>(column));
  }

 private:
  static constexpr bool is_dynamic = MostRows == Eigen::Dynamic;
  static constexpr int most_rows = is_dynamic ? 0 : MostRows;
  static constexpr int most_columns = is_dynamic ? 0 : MostColumns;
  local::Memory<Scalar, most_rows * most_columns> memory_;
  local::Table<Scalar> table_;
  local::Pivots<most_rows, most_columns> pivots_;
};

/// A system of as many rows as there are closures, or fewer, and up to twice as many columns.
template <typename Of, typename Scalar>
using ClosureSystem = SmallSystem<Scalar, Of::closures, 2 * Of::closures>;

/// A^-1 B; NaN if A has no inverse.
template <typename Of, typename Square, typename Right>
[[nodiscard]] Right solved(const Square& A, const Right& B) {
  using Scalar = typename Right::Scalar;
  const Eigen::Index size = A.rows();
  ClosureSystem<Of, Scalar> system(size, size + B.cols());
  system.put(0, A);
  system.put(size, B);
  Right result(size, B.cols());
  const bool is_solved = system.eliminate(size, size) > 0;
  for (Eigen::Index column = 0; column < B.cols(); ++column) {
    for (Eigen::Index row = 0; row < size; ++row) {
      result(row, column) = is_solved ? system.entry(system.row_of(row), size + column)
                                      : Scalar(std::numeric_limits<double>::quiet_NaN());
    }
  }
  return result;
}

}  // namespace assur::loops
