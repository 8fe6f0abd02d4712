// Formulas in a scene's symbols as expressions of emitted functions.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>

#include "emission/cpp/expression.hpp"

namespace assur::generator::emission::scene {

/// Expressions in place of symbols, by the names of the symbols.
using SymbolExpressions = std::map<std::string, cpp::Expression>;

/// Whether a formula contains no symbols and has a value.
[[nodiscard]] bool is_constant(const GiNaC::ex& formula);

/// The formula as an expression whose terms and factors have an order that depends only on the
/// formula. A symbol without an expression is a variable of its name.
[[nodiscard]] cpp::Expression expression_of(const GiNaC::ex& formula,
                                            const SymbolExpressions& symbols);

}  // namespace assur::generator::emission::scene
