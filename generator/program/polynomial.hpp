// Turns GiNaC expressions into polynomials in an order of our own, the same in every process.
#pragma once

#include <map>
#include <vector>

#include "program/coefficient.hpp"
#include "program/symbol_order.hpp"

namespace assur::generator::program {

/// A product of symbols, by ascending rank, a square as the rank twice.
using Monomial = std::vector<SymbolRank>;

/// A polynomial: coefficients by monomial, in lexicographic order of the ranks.
using Polynomial = std::map<Monomial, Coefficient>;

/// An expression as a polynomial in all symbols but constants; throws GeneratorError if it is not a
/// polynomial.
[[nodiscard]] Polynomial polynomial(const GiNaC::ex& expression, const SymbolOrder& order);
/// A polynomial as an expression, with its coefficients in the names of constants.
[[nodiscard]] GiNaC::ex expression(const Polynomial& polynomial, const SymbolOrder& order);

}  // namespace assur::generator::program
