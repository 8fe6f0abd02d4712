// Turns the variables and named quantities of equations into ranks, an order of our own.
#pragma once

#include <assur/text/index.hpp>
#include <map>
#include <string>
#include <vector>

#include "equations/implicit_equations.hpp"

namespace assur::generator::program {

using SymbolRank = text::Index<class SymbolOrder>;

/// Ranks symbols by the order in which they were declared. GiNaC orders by addresses, which differ
/// from run to run; nothing that is printed may depend on them.
class SymbolOrder {
 public:
  /// Declares a symbol; a name declared twice keeps its first rank.
  void declare(const GiNaC::symbol& symbol);
  /// The rank of a declared symbol; throws GeneratorError for any other.
  [[nodiscard]] SymbolRank rank(const GiNaC::symbol& symbol) const;
  [[nodiscard]] const std::string& name(SymbolRank rank) const { return names_[rank]; }

 private:
  std::map<std::string, SymbolRank> ranks_;
  text::Table<SymbolRank, std::string> names_;
};

/// Ranks the symbols of equations: unknowns, dimensions, inputs, rates, then named quantities.
[[nodiscard]] SymbolOrder symbol_order(const equations::ImplicitEquations& equations,
                                       const equations::Vocabulary& vocabulary);

}  // namespace assur::generator::program
