// Reads a LaTeX matrix as its cells.
#pragma once

#include <optional>

#include "latex/tokens.hpp"

namespace assur::generator::latex {

/// The cells of a matrix, an array or a column (a, b)^T. An array with rules after its first column
/// and row has titles.
struct LatexMatrix {
  std::vector<std::vector<Tokens>> cells;
  std::vector<Tokens> row_titles;
  std::vector<Tokens> column_titles;
  Place place;
};

/// The matrix that the given tokens form; empty if they contain none. Throws FormulaError for
/// determinants, products with matrices and rows of different lengths.
[[nodiscard]] std::optional<LatexMatrix> read_matrix(const Tokens& given);

}  // namespace assur::generator::latex
