#include "closures/numeric_matrix.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "closures/assembly_by_newton.hpp"
#include "equations/more_digits.hpp"

namespace assur::generator::closures {

namespace {

using Rows = std::vector<std::vector<GiNaC::numeric>>;

/// The rows of a matrix of real numbers; empty if an entry is not one.
Rows rows_of(const GiNaC::matrix& matrix) {
  Rows rows(matrix.rows());
  for (unsigned row = 0; row < matrix.rows(); ++row) {
    for (unsigned column = 0; column < matrix.cols(); ++column) {
      const GiNaC::ex& entry = matrix(row, column);
      if (!GiNaC::is_a<GiNaC::numeric>(entry) || !entry.info(GiNaC::info_flags::real)) {
        return {};
      }
      rows[row].push_back(GiNaC::ex_to<GiNaC::numeric>(entry));
    }
  }
  return rows;
}

/// Eliminates the first columns, as many as there are rows, which leaves the unit matrix there.
/// Returns the sign of their determinant, at once if it is 0. Pivots far smaller than any number of
/// a mechanism are rounding errors.
int eliminate(Rows& rows) {
  const GiNaC::numeric least = GiNaC::numeric(10).power(-60);
  int sign = 1;
  for (std::size_t column = 0; column < rows.size(); ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column; row < rows.size(); ++row) {
      if (GiNaC::abs(rows[row][column]) > GiNaC::abs(rows[pivot][column])) {
        pivot = row;
      }
    }
    const GiNaC::numeric divisor = rows[pivot][column];
    if (GiNaC::abs(divisor) <= least) {
      return 0;
    }
    sign *= (pivot == column ? 1 : -1) * (divisor.is_negative() ? -1 : 1);
    std::swap(rows[column], rows[pivot]);
    for (GiNaC::numeric& entry : rows[column]) {
      entry = entry / divisor;
    }
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const GiNaC::numeric factor = rows[row][column];
      for (std::size_t place = 0; row != column && place < rows[row].size(); ++place) {
        rows[row][place] = rows[row][place] - factor * rows[column][place];
      }
    }
  }
  return sign;
}

}  // namespace

GiNaC::matrix inverse_of(const GiNaC::matrix& matrix) {
  Rows rows = rows_of(matrix);
  if (rows.empty()) {
    return matrix.inverse();
  }
  const std::size_t size = rows.size();
  for (std::size_t row = 0; row < size; ++row) {
    rows[row].resize(2 * size, 0);
    rows[row][size + row] = 1;
  }
  if (eliminate(rows) == 0) {
    throw std::runtime_error("a singular matrix");
  }
  GiNaC::matrix inverse(matrix.rows(), matrix.cols());
  for (unsigned row = 0; row < matrix.rows(); ++row) {
    for (unsigned column = 0; column < matrix.cols(); ++column) {
      inverse(row, column) = rows[row][size + column];
    }
  }
  return inverse;
}

int determinant_sign(const GiNaC::matrix& matrix) {
  const equations::MoreDigits digits(solution_digits);
  Rows rows = rows_of(matrix);
  if (rows.empty()) {
    rows = rows_of(GiNaC::ex_to<GiNaC::matrix>(GiNaC::ex(matrix).evalf()));
  }
  return rows.empty() ? 0 : eliminate(rows);
}

}  // namespace assur::generator::closures
