// Turns an expression into the set of the symbols that occur in it.
#pragma once

#include <ginac/ginac.h>

namespace assur::generator::equations {

/// One walk through the expression, which serves where it is asked for many symbols.
[[nodiscard]] GiNaC::exset symbols_of(const GiNaC::ex& expression);

}  // namespace assur::generator::equations
