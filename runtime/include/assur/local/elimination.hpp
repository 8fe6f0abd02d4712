// Gauss-Jordan elimination with complete pivoting, for kernels and solutions of small systems.
#pragma once

#include <cmath>

namespace assur::local {

/// A matrix in memory of the caller, row by row. Its functions depend on no size, so a program has
/// them once.
template <typename Scalar>
class Table {
 public:
  Table(Scalar* entries, int rows, int columns)
      : entries_(entries), rows_(rows), columns_(columns) {
    for (int index = 0; index < rows * columns; ++index) {
      entries_[index] = 0;
    }
  }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int columns() const { return columns_; }
  Scalar& operator()(int row, int column) { return entries_[row * columns_ + column]; }
  const Scalar& operator()(int row, int column) const { return entries_[row * columns_ + column]; }

 private:
  Scalar* entries_;
  int rows_;
  int columns_;
};

/// Eliminates `rank` of the first `columns` columns, from all rows but one each, where a unit
/// remains; the other columns are transformed with them. `column_of` becomes the column that is
/// eliminated by each row, or -1, and `row_of` the row that eliminates each column, or -1. Returns
/// the last pivot in parts of the first; zero where no pivot is left.
template <typename Scalar>
[[nodiscard]] Scalar eliminate(Table<Scalar>& table, int columns, int rank, int* column_of,
                               int* row_of) {
  for (int row = 0; row < table.rows(); ++row) {
    column_of[row] = -1;
  }
  for (int column = 0; column < columns; ++column) {
    row_of[column] = -1;
  }
  Scalar first = 1;
  Scalar last = 1;
  for (int step = 0; step < rank; ++step) {
    Scalar largest = 0;
    int pivot_row = -1;
    int pivot_column = -1;
    for (int row = 0; row < table.rows(); ++row) {
      for (int column = 0; column < columns && column_of[row] < 0; ++column) {
        if (row_of[column] < 0 && std::abs(table(row, column)) > largest) {
          largest = std::abs(table(row, column));
          pivot_row = row;
          pivot_column = column;
        }
      }
    }
    if (pivot_row < 0) {
      return 0;
    }
    first = step == 0 ? largest : first;
    last = largest;
    column_of[pivot_row] = pivot_column;
    row_of[pivot_column] = pivot_row;
    const Scalar pivot = table(pivot_row, pivot_column);
    for (int column = 0; column < table.columns(); ++column) {
      table(pivot_row, column) /= pivot;
    }
    for (int row = 0; row < table.rows(); ++row) {
      const Scalar factor = table(row, pivot_column);
      for (int column = 0; column < table.columns() && row != pivot_row; ++column) {
        table(row, column) -= factor * table(pivot_row, column);
      }
    }
  }
  return last / first;
}

/// Directions that a matrix nearly loses: N spans what it takes to almost nothing, and W what it
/// hardly reaches; each has unit columns. `matrix` has room for as many further columns as it has
/// rows; they are zero.
template <typename Scalar>
void find_lost_directions(Table<Scalar>& matrix, int columns, int rank, Table<Scalar>& N,
                          Table<Scalar>& W, int* column_of, int* row_of) {
  const int rows = matrix.rows();
  for (int row = 0; row < rows; ++row) {
    matrix(row, columns + row) = 1;
  }
  (void)eliminate(matrix, columns, rank, column_of, row_of);
  const auto set_unit = [](Table<Scalar>& table, int column) {
    Scalar square = 0;
    for (int row = 0; row < table.rows(); ++row) {
      square += table(row, column) * table(row, column);
    }
    for (int row = 0; row < table.rows(); ++row) {
      table(row, column) /= std::sqrt(square);
    }
  };
  for (int column = 0, found = 0; column < columns && found < N.columns(); ++column) {
    if (row_of[column] < 0) {
      for (int other = 0; other < columns; ++other) {
        N(other, found) = row_of[other] < 0 ? 0 : -matrix(row_of[other], column);
      }
      N(column, found) = 1;
      set_unit(N, found++);
    }
  }
  for (int row = 0, found = 0; row < rows && found < W.columns(); ++row) {
    if (column_of[row] < 0) {
      for (int other = 0; other < rows; ++other) {
        W(other, found) = matrix(row, columns + other);
      }
      set_unit(W, found++);
    }
  }
}

}  // namespace assur::local
