// Turns the beginning of a C++ declaration into its type's length and sort.
#pragma once

#include "audit/code/tokens.hpp"

namespace assur::generator::audit::code {

/// Whether values of a type of this name are whole numbers.
[[nodiscard]] bool is_whole_type(const Token& token);

/// How many tokens of a declaration are its type; zero for what declares nothing.
[[nodiscard]] std::size_t type_length(Tokens tokens);

}  // namespace assur::generator::audit::code
