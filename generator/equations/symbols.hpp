// Turns an expression into the set of the symbols that occur in it.
#pragma once

#include <ginac/ginac.h>

namespace assur::generator::equations {

/// It takes one walk through the expression, where `has` takes one for each symbol.
[[nodiscard]] GiNaC::exset symbols_of(const GiNaC::ex& expression);

}  // namespace assur::generator::equations
