// Turns the tokens of a paper into its displayed equations with their numbers.
#pragma once

#include <map>
#include <set>

#include "latex/tokens.hpp"

namespace assur::generator::latex {

/// One numbered or displayed equation; a row of `align` is one of its own.
struct Displayed {
  std::string label;    ///< `(4)`: its tag or its number; `line 12` where it has none
  std::string section;  ///< under whose title it stands
  Place place;
  Tokens tokens;
};

/// A command of the paper that displays an equation: which argument is the equation, and which its
/// number; zero for none. The first is 1.
struct DisplayCommand {
  std::size_t arguments = 1;
  std::size_t equation = 1;
  std::size_t number = 0;
};

/// The displayed equations in their order. Formulas within the text are left out.
/// Throws FormulaError where an environment is not closed, and for files and conditions that are
/// not followed.
[[nodiscard]] std::vector<Displayed> displayed(
    const Tokens& tokens, const std::map<std::string, DisplayCommand>& commands);

/// The titles of parts, chapters and sections, whether or not they have equations.
[[nodiscard]] std::set<std::string> section_titles(const Tokens& tokens);

}  // namespace assur::generator::latex
