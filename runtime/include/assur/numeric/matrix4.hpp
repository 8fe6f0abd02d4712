// Linear algebra of vectors and square matrices of dimension four: products, solutions and null
// spaces.
//
// Plain loops of fixed length, because expression templates would take most of the compile time of
// a program with one emitted solver.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/index.hpp>
#include <cmath>
#include <utility>

namespace assur::numeric {

struct Vector4 {
  std::array<double, 4> entries{};

  [[nodiscard]] double& operator()(int row) { return detail::entry(entries, row); }
  [[nodiscard]] double operator()(int row) const { return detail::entry(entries, row); }
};

[[nodiscard]] inline Vector4 operator+(const Vector4& a, const Vector4& b) {
  return {{a(0) + b(0), a(1) + b(1), a(2) + b(2), a(3) + b(3)}};
}
[[nodiscard]] inline Vector4 operator-(const Vector4& a, const Vector4& b) {
  return {{a(0) - b(0), a(1) - b(1), a(2) - b(2), a(3) - b(3)}};
}
[[nodiscard]] inline Vector4 operator*(double factor, const Vector4& a) {
  return {{factor * a(0), factor * a(1), factor * a(2), factor * a(3)}};
}
[[nodiscard]] inline double dot(const Vector4& a, const Vector4& b) {
  return a(0) * b(0) + a(1) * b(1) + a(2) * b(2) + a(3) * b(3);
}
[[nodiscard]] inline double norm(const Vector4& a) { return std::sqrt(dot(a, a)); }
/// Zero stays zero.
[[nodiscard]] inline Vector4 normalised(const Vector4& a) {
  const double length = norm(a);
  return length > 0 ? (1 / length) * a : a;
}

struct Matrix4 {
  std::array<Vector4, 4> columns{};

  [[nodiscard]] static Matrix4 identity() {
    Matrix4 result;
    for (int row = 0; row < 4; ++row) {
      result(row, row) = 1;
    }
    return result;
  }
  [[nodiscard]] Vector4& column(int index) { return detail::entry(columns, index); }
  [[nodiscard]] const Vector4& column(int index) const { return detail::entry(columns, index); }
  [[nodiscard]] double& operator()(int row, int index) { return column(index)(row); }
  [[nodiscard]] double operator()(int row, int index) const { return column(index)(row); }
};

[[nodiscard]] inline Matrix4 transposed(const Matrix4& A) {
  Matrix4 result;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      result(row, column) = A(column, row);
    }
  }
  return result;
}
/// A^T x.
[[nodiscard]] inline Vector4 transposed_product(const Matrix4& A, const Vector4& x) {
  return {{dot(A.column(0), x), dot(A.column(1), x), dot(A.column(2), x), dot(A.column(3), x)}};
}

/// Gaussian elimination of a matrix with full pivoting: the factors L and U, with the rows and
/// columns of the matrix in the order in which they were eliminated.
class Elimination {
 public:
  /// A pivot of at most `threshold` times the largest counts as zero.
  Elimination(const Matrix4& A, double threshold) : factors_(A) {
    double largest = 0;
    for (int step = 0; step < 4; ++step) {
      const double pivot = bring_pivot(step);
      if (!(pivot > 0)) {
        return;
      }
      largest = (std::max)(largest, pivot);
      if (pivot > threshold * largest) {
        ++rank_;
      }
      eliminate(step);
    }
  }

  [[nodiscard]] int rank() const { return rank_; }

  /// x with A x = b in `rank` rows; the other unknowns are zero.
  [[nodiscard]] Vector4 solve(const Vector4& b) const {
    Vector4 x;
    for (int row = 0; row < rank_; ++row) {
      x(row) = b(detail::entry(rows_, row));
      for (int column = 0; column < row; ++column) {
        x(row) -= factors_(row, column) * x(column);
      }
    }
    return substituted_back(x);
  }

  /// One of 4 - rank independent x with A x = 0.
  [[nodiscard]] Vector4 null_vector(int index) const {
    const Vector4& free = factors_.column(rank_ + index);
    Vector4 x;
    for (int row = 0; row < rank_; ++row) {
      x(row) = -free(row);
    }
    Vector4 result = substituted_back(x);
    result(detail::entry(columns_, rank_ + index)) = 1;
    return result;
  }

 private:
  /// Exchanges rows and columns so that the largest remaining entry is the next pivot. Returns its
  /// size.
  double bring_pivot(int step) {
    int row = step;
    int column = step;
    double largest = std::abs(factors_(step, step));
    for (int j = step; j < 4; ++j) {
      for (int i = step; i < 4; ++i) {
        const double size = std::abs(factors_(i, j));
        if (size > largest) {
          largest = size;
          row = i;
          column = j;
        }
      }
    }
    if (column != step) {
      std::swap(factors_.column(step), factors_.column(column));
      std::swap(detail::entry(columns_, step), detail::entry(columns_, column));
    }
    if (row != step) {
      for (Vector4& entries : factors_.columns) {
        std::swap(entries(step), entries(row));
      }
      std::swap(detail::entry(rows_, step), detail::entry(rows_, row));
    }
    return largest;
  }

  void eliminate(int step) {
    Vector4& multiples = factors_.column(step);
    for (int row = step + 1; row < 4; ++row) {
      multiples(row) /= multiples(step);
    }
    for (int index = step + 1; index < 4; ++index) {
      Vector4& column = factors_.column(index);
      const double top = column(step);
      for (int row = step + 1; row < 4; ++row) {
        column(row) -= top * multiples(row);
      }
    }
  }

  /// U^-1 x, in the order of the unknowns.
  [[nodiscard]] Vector4 substituted_back(Vector4 x) const {
    Vector4 result;
    for (int row = rank_ - 1; row >= 0; --row) {
      x(row) /= factors_(row, row);
      for (int above = 0; above < row; ++above) {
        x(above) -= factors_(above, row) * x(row);
      }
      result(detail::entry(columns_, row)) = x(row);
    }
    return result;
  }

  Matrix4 factors_;
  std::array<int, 4> rows_{0, 1, 2, 3};
  std::array<int, 4> columns_{0, 1, 2, 3};
  int rank_ = 0;
};

}  // namespace assur::numeric
