// Turns named quantities and results into those of one mechanism: numbers in place of symbols.
#pragma once

#include <vector>

#include "program/program.hpp"

namespace assur::generator::emission::scene {

/// What a `Program` is made of.
struct NamedResults {
  std::vector<equations::NamedQuantity> quantities;
  std::vector<program::Result> results;
};

/// Puts `values` in place of symbols, in the definitions of the quantities and in the results, and
/// folds exactly; numbers are those that the constants of `order` make. A quantity that becomes a
/// number, or a symbol up to its sign, is put in place of its name, and so is a multiple that is
/// used once, where it is scaled again; a number that is divided by constants becomes one of them.
/// Numbers are taken out of reciprocals, and factors by which a term is both multiplied and divided
/// are cancelled. This is the last step before common subexpressions: in elimination, the two
/// rounded parts of a direction would not satisfy cos^2 + sin^2 = 1. Throws InputError where a
/// reciprocal is of zero.
[[nodiscard]] NamedResults specialised(const std::vector<equations::NamedQuantity>& quantities,
                                       const std::vector<program::Result>& results,
                                       program::SymbolOrder& order, GiNaC::exmap values);

}  // namespace assur::generator::emission::scene
