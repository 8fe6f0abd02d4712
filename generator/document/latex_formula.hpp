// Turns formulas in the syntax of scene files, and prose that holds their names, into LaTeX.
#pragma once

#include <string>

namespace assur::generator::document {

/// A formula for math mode. Lines may be broken at its signs: products hold no space.
[[nodiscard]] std::string latex_formula(const std::string& formula);
/// A vector equation such as `B + slide_B + BC - E = 0`.
[[nodiscard]] std::string latex_vectors(const std::string& equation);
/// Prose, with what stands in backquotes, or has an underscore or an exponent, as a formula.
[[nodiscard]] std::string latex_prose(const std::string& text);
/// The width of a formula in ems, roughly.
[[nodiscard]] double formula_width(const std::string& formula);

}  // namespace assur::generator::document
