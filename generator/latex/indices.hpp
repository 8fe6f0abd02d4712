// Turns formulas with an index into the formulas of its values.
#pragma once

#include "latex/tokens.hpp"

namespace assur::generator::latex {

/// Tokens with a value in place of an index, wherever it stands in a subscript.
[[nodiscard]] Tokens with_index(const Tokens& tokens, const std::string& index,
                                const std::string& value);
/// Whether an index stands in a subscript.
[[nodiscard]] bool has_index(const Tokens& tokens, const std::string& index);

}  // namespace assur::generator::latex
