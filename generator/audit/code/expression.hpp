// Turns an expression of C++ or MATLAB into its value.
#pragma once

#include "audit/code/variables.hpp"

namespace assur::generator::audit::code {

/// Sums, products, quotients, signs, brackets, calls of the functions that formulas have, numbers,
/// pi, and variables; in MATLAB powers as well. The cell has a reason in place of a value where
/// a formula could not be read either. Throws Unreadable for a variable that cannot be read, and
/// CodeError for everything else, since it may do more than give a value.
[[nodiscard]] Cell read_expression(Tokens tokens, Variables& variables, const TypeNames* types,
                                   std::vector<Spelled>* used = nullptr);

}  // namespace assur::generator::audit::code
