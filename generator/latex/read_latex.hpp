// Turns the tokens of a formula into an expression in the names of quantities. What a reader of the
// paper could take in two ways is refused, at its place.
#pragma once

#include <assur/text/expression.hpp>
#include <map>

#include "latex/notation.hpp"

namespace assur::generator::latex {

/// How formulas are read.
struct Reading {
  const Notations& notations;
  bool brackets_multiply = false;  ///< `a(b + c)` is a product, never a call
  bool blanks_are_zero = false;    ///< entries of matrices without a text
  /// Indices that are summed over where a product has them, with their values.
  std::map<std::string, std::vector<std::string>> summed = {};
};

/// A formula, and where its parts stand: the column of a part counts in `places`, from 1.
struct LatexFormula {
  text::Expression tree;
  std::vector<Place> places;
};

/// The name in a tree of what the paper itself defines.
[[nodiscard]] std::string printed_name(const std::string& notation);

/// Throws FormulaError. `place` is where a formula that has no tokens should stand.
[[nodiscard]] LatexFormula read_latex(const Tokens& tokens, const Reading& reading, Place place);

/// A matrix, an array or a column (a, b)^T, by its cells. An array whose first column and row are
/// ruled off has titles.
struct LatexMatrix {
  std::vector<std::vector<Tokens>> cells;
  std::vector<Tokens> row_titles;
  std::vector<Tokens> column_titles;
  Place place;
};

/// The matrix that the tokens are as a whole; nothing if there is none in them. Throws FormulaError
/// for determinants, products with matrices and rows of different lengths.
[[nodiscard]] std::optional<LatexMatrix> read_matrix(const Tokens& tokens);

/// Tokens with a value in place of an index, wherever it stands in a subscript.
[[nodiscard]] Tokens with_index(const Tokens& tokens, const std::string& index,
                                const std::string& value);
/// Whether an index stands in a subscript.
[[nodiscard]] bool has_index(const Tokens& tokens, const std::string& index);

}  // namespace assur::generator::latex
