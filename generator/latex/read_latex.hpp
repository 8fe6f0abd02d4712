// Reads a LaTeX formula as an expression in quantities. Ambiguous notation is an error at its
// place.
#pragma once

#include <assur/text/expression.hpp>
#include <map>

#include "latex/notation.hpp"

namespace assur::generator::latex {

/// The conventions for reading formulas.
struct Reading {
  const Notations& notations;
  bool brackets_multiply = false;  ///< `a(b + c)` is a product, not a call
  bool blanks_are_zero = false;    ///< an empty entry of a matrix is zero
  /// The summation indices of products, with their values.
  std::map<std::string, std::vector<std::string>> summed = {};
};

/// A formula and the places of its parts: the column of a part is its index in `places`, from 1.
struct LatexFormula {
  text::Expression tree;
  std::vector<Place> places;
};

/// The name in trees of a quantity that the paper itself defines.
[[nodiscard]] std::string printed_name(const std::string& notation);

/// Throws FormulaError. `place` is where a missing formula should stand.
[[nodiscard]] LatexFormula read_latex(const Tokens& tokens, const Reading& reading, Place place);

}  // namespace assur::generator::latex
