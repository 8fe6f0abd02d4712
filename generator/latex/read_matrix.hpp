// Turns the tokens of a matrix into its cells.
#pragma once

#include <optional>

#include "latex/tokens.hpp"

namespace assur::generator::latex {

/// A matrix, an array or a column (a, b)^T, by its cells. An array whose first column and row are
/// ruled off has titles.
struct LatexMatrix {
  std::vector<std::vector<Tokens>> cells;
  std::vector<Tokens> row_titles;
  std::vector<Tokens> column_titles;
  Place place;
};

/// The matrix that all the given tokens form; nothing if they contain none. Throws
/// FormulaError for determinants, products with matrices and rows of different lengths.
[[nodiscard]] std::optional<LatexMatrix> read_matrix(const Tokens& given);

}  // namespace assur::generator::latex
