// Entrywise operations on matrices of fixed size by plain loops.
//
// Eigen's expression templates would dominate the compile time of emitted solvers. The loops are
// marked for unrolling, as Eigen's are.
#pragma once

#include <algorithm>
#include <array>
#include <assur/model.hpp>
#include <cstddef>

namespace assur::numeric {

/// Sets every entry.
template <typename Scalar, int Rows, int Columns>
void fill(Matrix<Scalar, Rows, Columns>& matrix, const Scalar& value) {
  std::fill_n(matrix.data(), Rows * Columns, value);
}

/// A matrix of zeros.
template <typename Zeros>
[[nodiscard]] Zeros zeros() {
  Zeros matrix;
  fill(matrix, typename Zeros::Scalar(0));
  return matrix;
}

/// One column.
template <typename Scalar, int Rows, int Columns>
[[nodiscard]] Vector<Scalar, Rows> column(const Matrix<Scalar, Rows, Columns>& matrix, int index) {
  Vector<Scalar, Rows> result;
#pragma GCC unroll 16
  for (int row = 0; row < Rows; ++row) {
    result(row) = matrix(row, index);
  }
  return result;
}

/// Sets one column.
template <typename Scalar, int Rows, int Columns>
void set_column(Matrix<Scalar, Rows, Columns>& matrix, int index,
                const Vector<Scalar, Rows>& values) {
#pragma GCC unroll 16
  for (int row = 0; row < Rows; ++row) {
    matrix(row, index) = values(row);
  }
}

/// Sets a row to the values times a scale.
template <typename Scalar, int Rows, int Columns>
void set_row(Matrix<Scalar, Rows, Columns>& matrix, int index,
             const Matrix<Scalar, 1, Columns>& values, const Scalar& scale = Scalar(1)) {
#pragma GCC unroll 16
  for (int column = 0; column < Columns; ++column) {
    matrix(index, column) = values(column) * scale;
  }
}

/// Adds `Sign` times a product to a matrix, column by column: the entries of a column are adjacent,
/// so that compilers compute several at once.
template <int Sign = 1, typename Scalar, int Rows, int Inner, int Columns>
void add_product(Matrix<Scalar, Rows, Columns>& sum, const Matrix<Scalar, Rows, Inner>& left,
                 const Matrix<Scalar, Inner, Columns>& right) {
#pragma GCC unroll 16
  for (int column = 0; column < Columns; ++column) {
    std::array<Scalar, static_cast<std::size_t>(Rows)> entries;
    std::copy_n(sum.data() + column * Rows, Rows, entries.begin());
#pragma GCC unroll 16
    for (int inner = 0; inner < Inner; ++inner) {
      const Scalar factor = Sign * right(inner, column);
#pragma GCC unroll 16
      for (int row = 0; row < Rows; ++row) {
        entries[static_cast<std::size_t>(row)] += left(row, inner) * factor;
      }
    }
    std::copy_n(entries.begin(), Rows, sum.data() + column * Rows);
  }
}

}  // namespace assur::numeric
