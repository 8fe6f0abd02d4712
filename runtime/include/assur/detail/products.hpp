// Products and inverses of small matrices without Eigen's run-time checks, which would link
// functions that abort the program.
#pragma once

#include <assur/model.hpp>

namespace assur::detail {

template <typename Scalar, int Rows, int Inner, int Columns>
[[nodiscard, gnu::always_inline]] inline Matrix<Scalar, Rows, Columns> product(
    const Matrix<Scalar, Rows, Inner>& one, const Matrix<Scalar, Inner, Columns>& other) {
  Matrix<Scalar, Rows, Columns> result;
  for (int column = 0; column < Columns; ++column) {
    for (int row = 0; row < Rows; ++row) {
      Scalar sum = one.coeff(row, 0) * other.coeff(0, column);
      for (int inner = 1; inner < Inner; ++inner) {
        sum = sum + one.coeff(row, inner) * other.coeff(inner, column);
      }
      result.coeffRef(row, column) = sum;
    }
  }
  return result;
}

/// The inverse of a matrix of one or two rows; infinite or NaN if there is none.
template <typename Scalar, int Rows>
void invert(const Matrix<Scalar, Rows, Rows>& matrix, Matrix<Scalar, Rows, Rows>& inverse) {
  static_assert(Rows == 1 || Rows == 2, "larger groups have an inverse of their own");
  if constexpr (Rows == 1) {
    inverse(0, 0) = Scalar(1) / matrix(0, 0);
  } else {
    const Scalar reciprocal =
        Scalar(1) / (matrix(0, 0) * matrix(1, 1) - matrix(0, 1) * matrix(1, 0));
    inverse(0, 0) = matrix(1, 1) * reciprocal;
    inverse(0, 1) = -matrix(0, 1) * reciprocal;
    inverse(1, 0) = -matrix(1, 0) * reciprocal;
    inverse(1, 1) = matrix(0, 0) * reciprocal;
  }
}

}  // namespace assur::detail
