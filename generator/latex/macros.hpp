// Expands the commands that a paper defines.
#pragma once

#include <set>

#include "latex/tokens.hpp"

namespace assur::generator::latex {

/// Replaces the commands defined by \newcommand, \renewcommand, \def and \DeclareMathOperator, with
/// their arguments, and removes the definitions. A token of an argument keeps its place, one of a
/// definition takes that of the call. Commands in `kept` are not replaced. Throws FormulaError if a
/// definition of another form is used, and if the replacements do not end.
[[nodiscard]] Tokens expanded(const Tokens& tokens, const std::set<std::string>& kept);

}  // namespace assur::generator::latex
