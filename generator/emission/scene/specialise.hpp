// Named quantities and results with the numbers of one mechanism in place of symbols.
#pragma once

#include <vector>

#include "program/program.hpp"

namespace assur::generator::emission::scene {

/// The quantities and results from which a `Program` is made.
struct NamedResults {
  std::vector<equations::NamedQuantity> quantities;
  std::vector<program::Result> results;
};

/// Substitutes `values` for symbols, in the definitions of the quantities and in the results, and
/// folds exactly; expressions in the constants of `order` are numbers, too. A quantity that becomes
/// a number, or a symbol up to its sign, replaces its name, and so does a multiple that is used
/// once and is scaled again there; a number that was divided by constants becomes a constant
/// itself. Numbers are extracted from reciprocals, and factors by which a term is both multiplied
/// and divided cancel. The reciprocal of zero becomes zero. This is the last step before common
/// subexpressions are shared: during elimination, the two rounded parts of a direction would not
/// satisfy cos^2 + sin^2 = 1.
[[nodiscard]] NamedResults specialised(const std::vector<equations::NamedQuantity>& quantities,
                                       const std::vector<program::Result>& results,
                                       program::SymbolOrder& order, GiNaC::exmap values);

}  // namespace assur::generator::emission::scene
