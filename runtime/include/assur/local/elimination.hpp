// Gauss-Jordan elimination with complete pivoting: solutions and null spaces of small systems.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace assur::local {

/// Storage for numbers: of fixed size and without allocation, or, if `Most` is zero, of dynamic
/// size.
template <typename Number, int Most>
using Memory = std::conditional_t<(Most > 0), std::array<Number, static_cast<std::size_t>(Most)>,
                                  std::vector<Number>>;

/// Sets the first `count` numbers to a value.
template <typename Number, std::size_t Most>
void reserve(std::array<Number, Most>& memory, int count, Number value) {
  std::fill_n(memory.begin(), static_cast<std::size_t>(count), value);
}
template <typename Number>
void reserve(std::vector<Number>& memory, int count, Number value) {
  memory.assign(static_cast<std::size_t>(count), value);
}

/// A row-major matrix in memory that it does not own. Its functions depend on no size, so a program
/// contains them once.
template <typename Scalar>
class Table {
 public:
  /// The memory must outlive the table. All entries become zero.
  template <typename Numbers>
  Table(Numbers& memory, int rows, int columns) : rows_(rows), columns_(columns) {
    reserve(memory, rows * columns, Scalar(0));
    entries_ = memory.data();
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

/// The pivot row of each column and the pivot column of each row; -1 for none.
template <int MostRows, int MostColumns>
class Pivots {
 public:
  [[nodiscard]] int column_of(int row) const { return columns_[static_cast<std::size_t>(row)]; }
  [[nodiscard]] int row_of(int column) const { return rows_[static_cast<std::size_t>(column)]; }
  void begin(int rows, int columns) {
    reserve(columns_, rows, -1);
    reserve(rows_, columns, -1);
  }
  void add(int row, int column) {
    columns_[static_cast<std::size_t>(row)] = column;
    rows_[static_cast<std::size_t>(column)] = row;
  }

 private:
  Memory<int, MostRows> columns_;
  Memory<int, MostColumns> rows_;
};

/// The absolute value of a number, real or complex.
template <typename Scalar>
[[nodiscard]] auto magnitude(const Scalar& number) {
  using std::abs;
  return abs(number);
}
template <typename Scalar>
using SizeOf = decltype(magnitude(Scalar()));

/// The size by which pivots are compared; for complex numbers it needs no square root.
template <typename Scalar>
[[nodiscard]] auto pivot_size(const Scalar& entry) {
  return magnitude(entry);
}
template <typename Scalar>
[[nodiscard]] Scalar pivot_size(const std::complex<Scalar>& entry) {
  return std::abs(entry.real()) + std::abs(entry.imag());
}

/// Takes as pivot the largest entry above `least` in the first `columns` columns, among rows and
/// columns without a pivot. Scales its row so that the pivot becomes one and eliminates its column
/// from all other rows. Returns the size of the entry; zero if none is above `least`.
template <typename Scalar, typename Pivots>
[[nodiscard]] SizeOf<Scalar> eliminate_largest(Table<Scalar>& table, int columns,
                                               SizeOf<Scalar> least, Pivots& pivots) {
  SizeOf<Scalar> largest = least;
  int pivot_row = -1;
  int pivot_column = -1;
  for (int row = 0; row < table.rows(); ++row) {
    for (int column = 0; column < columns && pivots.column_of(row) < 0; ++column) {
      if (pivots.row_of(column) < 0 && pivot_size(table(row, column)) > largest) {
        largest = pivot_size(table(row, column));
        pivot_row = row;
        pivot_column = column;
      }
    }
  }
  if (pivot_row < 0) {
    return 0;
  }
  pivots.add(pivot_row, pivot_column);
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
  return largest;
}

/// Eliminates `rank` of the first `columns` columns, one after the other. Returns the ratio of the
/// last pivot to the first; zero if no pivot is left.
template <typename Scalar, typename Pivots>
[[nodiscard]] SizeOf<Scalar> eliminate(Table<Scalar>& table, int columns, int rank,
                                       Pivots& pivots) {
  pivots.begin(table.rows(), columns);
  SizeOf<Scalar> first = 1;
  SizeOf<Scalar> last = 1;
  for (int step = 0; step < rank; ++step) {
    last = eliminate_largest(table, columns, SizeOf<Scalar>(0), pivots);
    if (last == 0) {
      return 0;
    }
    first = step == 0 ? last : first;
  }
  return last / first;
}

/// Scales a column to unit length.
template <typename Scalar>
void set_unit(Table<Scalar>& table, int column) {
  Scalar square = 0;
  for (int row = 0; row < table.rows(); ++row) {
    square += table(row, column) * table(row, column);
  }
  for (int row = 0; row < table.rows(); ++row) {
    table(row, column) /= std::sqrt(square);
  }
}

/// Null spaces of a matrix of nearly deficient rank: N spans the right null space, W the left one,
/// each by unit columns. Behind its `columns` columns, `matrix` has as many zero columns as it has
/// rows.
template <typename Scalar, typename Pivots>
void find_lost_directions(Table<Scalar>& matrix, int columns, int rank, Table<Scalar>& N,
                          Table<Scalar>& W, Pivots& pivots) {
  const int rows = matrix.rows();
  for (int row = 0; row < rows; ++row) {
    matrix(row, columns + row) = 1;
  }
  (void)eliminate(matrix, columns, rank, pivots);
  for (int column = 0, found = 0; column < columns && found < N.columns(); ++column) {
    if (pivots.row_of(column) < 0) {
      for (int other = 0; other < columns; ++other) {
        const int row = pivots.row_of(other);
        N(other, found) = row < 0 ? 0 : -matrix(row, column);
      }
      N(column, found) = 1;
      set_unit(N, found++);
    }
  }
  for (int row = 0, found = 0; row < rows && found < W.columns(); ++row) {
    if (pivots.column_of(row) < 0) {
      for (int other = 0; other < rows; ++other) {
        W(other, found) = matrix(row, columns + other);
      }
      set_unit(W, found++);
    }
  }
}

}  // namespace assur::local
