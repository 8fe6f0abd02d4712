// The set of symbols in an expression.
#pragma once

#include <ginac/ginac.h>

namespace assur::generator::equations {

/// One walk through the expression finds all; `has` takes one walk for each symbol.
[[nodiscard]] GiNaC::exset symbols_of(const GiNaC::ex& expression);

}  // namespace assur::generator::equations
