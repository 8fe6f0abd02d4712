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

/// A formula, and the places of its parts: the column of a part is its number in `places`, from 1.
struct LatexFormula {
  text::Expression tree;
  std::vector<Place> places;
};

/// The name that trees use for a quantity that the paper itself defines.
[[nodiscard]] std::string printed_name(const std::string& notation);

/// Throws FormulaError. `place` is where a formula that has no tokens should stand.
[[nodiscard]] LatexFormula read_latex(const Tokens& tokens, const Reading& reading, Place place);

}  // namespace assur::generator::latex
