// Polynomials of GiNaC expressions with an order of terms that is the same in every process.
#pragma once

#include <map>
#include <vector>

#include "program/coefficient.hpp"
#include "program/symbol_order.hpp"

namespace assur::generator::program {

/// A product of symbols by ascending rank; a square repeats the rank.
using Monomial = std::vector<SymbolRank>;

/// A polynomial: coefficients by monomial, in lexicographic order of the ranks.
using Polynomial = std::map<Monomial, Coefficient>;

/// An expression as a polynomial in all symbols except constants; throws GeneratorError if it is
/// not one.
[[nodiscard]] Polynomial polynomial(const GiNaC::ex& expression, const SymbolOrder& order);
/// A polynomial as an expression, with coefficients in named constants.
[[nodiscard]] GiNaC::ex expression(const Polynomial& polynomial, const SymbolOrder& order);

}  // namespace assur::generator::program
