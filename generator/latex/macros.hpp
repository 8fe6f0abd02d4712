// Turns tokens with the writer's own commands into tokens without them.
#pragma once

#include <set>

#include "latex/tokens.hpp"

namespace assur::generator::latex {

/// Replaces what \newcommand, \renewcommand, \def and \DeclareMathOperator define, with arguments
/// where they have some, and leaves the definitions out. A token of an argument keeps its place,
/// one of a definition takes that of the call. `kept` are commands that are not replaced. Throws
/// FormulaError where a definition of another form is used, and where replacing does not end.
[[nodiscard]] Tokens expanded(const Tokens& tokens, const std::set<std::string>& kept);

}  // namespace assur::generator::latex
