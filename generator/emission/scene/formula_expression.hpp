// Turns formulas in a scene's symbols into expressions of emitted functions.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>

#include "emission/cpp/expression.hpp"

namespace assur::generator::emission::scene {

/// The expressions that symbols stand for, by the names of the symbols.
using SymbolExpressions = std::map<std::string, cpp::Expression>;

/// Whether a formula contains no symbols and has a value.
[[nodiscard]] bool is_constant(const GiNaC::ex& formula);

/// The formula as an expression whose terms and factors are in an order that depends on the formula
/// alone. A symbol that stands for no expression is a variable of its name.
[[nodiscard]] cpp::Expression expression_of(const GiNaC::ex& formula,
                                            const SymbolExpressions& symbols);

}  // namespace assur::generator::emission::scene
