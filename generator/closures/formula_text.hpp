// Turns an expression into text that is the same in every process and that a formula may be.
#pragma once

#include <ginac/ginac.h>

#include <string>

namespace assur::generator {

/// Sums and products in alphabetical order: GiNaC's own order depends on addresses.
[[nodiscard]] std::string formula_text(const GiNaC::ex& expression);

}  // namespace assur::generator
