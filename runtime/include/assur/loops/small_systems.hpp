// Linear systems of a group's closures. Their code depends on few sizes, so that compilers have
// little of it: decompositions of matrices of each size would take minutes.
#pragma once

#include <Eigen/Core>
#include <assur/local/elimination.hpp>
#include <assur/loops/loop_equations.hpp>
#include <limits>

namespace assur::loops {

/// A matrix of some rows, of the closures or fewer, and as many columns, and others beside it.
template <typename Of, typename Scalar>
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
  /// Eliminates some of the first columns; the last pivot in parts of the first.
  [[nodiscard]] double eliminate(Eigen::Index columns, Eigen::Index rank) {
    return local::eliminate(table_, static_cast<int>(columns), static_cast<int>(rank), pivots_);
  }
  /// Eliminates columns as long as pivots exceed a part of the first one; their number.
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
  /// The row that eliminates a column; -1 where none does.
  [[nodiscard]] int row_of(Eigen::Index column) const {
    return pivots_.row_of(static_cast<int>(column));
  }
  [[nodiscard]] Scalar& entry(Eigen::Index row, Eigen::Index column) {
    return table_(static_cast<int>(row), static_cast<int>(column));
  }

 private:
  static constexpr int most_rows = Of::closures == Eigen::Dynamic ? 0 : Of::closures;
  local::Memory<Scalar, 2 * most_rows * most_rows> memory_;
  local::Table<Scalar> table_;
  local::Pivots<most_rows, most_rows> pivots_;
};

/// A^-1 B; NaN where A has no inverse.
template <typename Of, typename Square, typename Right>
[[nodiscard]] Right solved(const Square& A, const Right& B) {
  using Scalar = typename Right::Scalar;
  const Eigen::Index size = A.rows();
  SmallSystem<Of, Scalar> system(size, size + B.cols());
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
