// Turns the displayed equations of a paper into its statements: which closure, or which quantity of
// its own, each of them gives.
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
  std::string defines = {};                          ///< a name that the paper gives
  std::string closure = {};                          ///< the closure that it prints
  std::optional<closures::FormulaError> error = {};  ///< why it cannot be read
};

/// The statements of a paper but for those that the map skips. Throws FormulaError for a file that
/// cannot be followed.
[[nodiscard]] std::vector<Stated> paper_statements(const Tokens& tokens, PaperMap& map);

}  // namespace assur::generator::audit::latex
