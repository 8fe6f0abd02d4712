// Turns the displayed equations of a paper into statements, with the closure that each prints or
// the name that it defines, if any.
#pragma once

#include <optional>

#include "audit/latex/paper_map.hpp"

namespace assur::generator::audit::latex {

/// One statement of a displayed equation.
struct Stated {
  std::string label;
  closures::Place place;
  Tokens tokens;
  std::vector<Tokens> sides = {};
  std::string defines = {};                          ///< the name that it defines, if any
  std::string closure = {};                          ///< the closure that it prints, if any
  std::optional<closures::FormulaError> error = {};  ///< why it cannot be read
};

/// The statements of a paper, except those that the map skips. Throws FormulaError for a file that
/// cannot be followed.
[[nodiscard]] std::vector<Stated> paper_statements(const Tokens& tokens, PaperMap& map);

}  // namespace assur::generator::audit::latex
