// Names, formulas and prose of a derivation in LaTeX.
#pragma once

#include <string>

namespace assur::generator::document {

/// A name in two parts with the place of an exponent between them: `\cos` and `\theta`; or the
/// whole name and an empty text.
struct LatexName {
  std::string head;
  std::string tail;

  [[nodiscard]] std::string whole() const { return head + tail; }
};

[[nodiscard]] LatexName latex_name(const std::string& name);
/// A word of several letters, typeset as one.
[[nodiscard]] std::string latex_word(const std::string& letters);

/// A formula for math mode. TeX may break a line before a sign that follows a space.
[[nodiscard]] std::string latex_formula(const std::string& formula);
/// A vector equation such as `B + slide_B + BC - E = 0`.
[[nodiscard]] std::string latex_vectors(const std::string& equation);
/// Prose in which text in backquotes, and words with an underscore or an exponent, are formulas.
[[nodiscard]] std::string latex_prose(const std::string& text);
/// The approximate width of a formula in ems.
[[nodiscard]] double formula_width(const std::string& formula);

}  // namespace assur::generator::document
