// Turns lines for the preprocessor into a refusal where they may change what the code says.
#pragma once

#include "audit/code/tokens.hpp"

namespace assur::generator::audit::code {

/// Throws CodeError unless all directives change nothing: known headers, `#pragma once`, `#define
/// _USE_MATH_DEFINES`, and a guard around the file.
void check_directives(Tokens tokens);

}  // namespace assur::generator::audit::code
