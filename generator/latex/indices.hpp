// Substitutes values for an index in formulas.
#pragma once

#include "latex/tokens.hpp"

namespace assur::generator::latex {

/// Tokens with a value in place of an index in every subscript.
[[nodiscard]] Tokens with_index(const Tokens& tokens, const std::string& index,
                                const std::string& value);
/// Whether an index occurs in a subscript.
[[nodiscard]] bool has_index(const Tokens& tokens, const std::string& index);

}  // namespace assur::generator::latex
