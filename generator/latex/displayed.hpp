// Displayed equations of a LaTeX paper with their numbers.
#pragma once

#include <map>
#include <set>

#include "latex/tokens.hpp"

namespace assur::generator::latex {

/// One numbered or displayed equation; each row of `align` is one.
struct Displayed {
  std::string label;    ///< `(4)`: its tag or its number; `line 12` if it has none
  std::string section;  ///< title of its section
  Place place;
  Tokens tokens;
};

/// A command of the paper that displays an equation: the argument that is the equation, and the one
/// that is its number; zero for none. The first is 1.
struct DisplayCommand {
  std::size_t arguments = 1;
  std::size_t equation = 1;
  std::size_t number = 0;
};

/// The displayed equations in order, without formulas in the text. Throws FormulaError for an
/// unclosed environment, and for files and conditions that are not read.
[[nodiscard]] std::vector<Displayed> displayed(
    const Tokens& tokens, const std::map<std::string, DisplayCommand>& commands);

/// The titles of parts, chapters and sections, with or without equations.
[[nodiscard]] std::set<std::string> section_titles(const Tokens& tokens);

}  // namespace assur::generator::latex
