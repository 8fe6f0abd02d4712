// Ranks of the variables and named quantities of equations, the same in every process.
#pragma once

#include <assur/text/index.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "equations/implicit_equations.hpp"

namespace assur::generator::program {

using SymbolRank = text::Index<class SymbolOrder>;

/// The unit of a quantity: powers of length and time.
struct Measure {
  int length = 0;
  int time = 0;

  /// Its position in a product: lengths, then directions and other ratios, then rates.
  [[nodiscard]] int place() const { return time != 0 ? 2 : length != 0 ? 0 : 1; }
};

/// Ranks symbols in order of declaration. GiNaC orders by addresses, which differ from run to run;
/// printed results must not depend on them.
class SymbolOrder {
 public:
  /// Declares a symbol; a name declared twice keeps its first rank.
  void declare(const GiNaC::symbol& symbol, Measure measure = {1, 0});
  /// Makes a declared symbol a named constant: programs hold it in their coefficients.
  void set_constant(const GiNaC::symbol& symbol, const GiNaC::numeric& value);

  [[nodiscard]] bool declares(const std::string& name) const { return ranks_.contains(name); }
  /// The rank of a declared symbol; throws GeneratorError for any other.
  [[nodiscard]] SymbolRank rank(const GiNaC::symbol& symbol) const;
  [[nodiscard]] const GiNaC::symbol& symbol(SymbolRank rank) const { return entries_[rank].symbol; }
  [[nodiscard]] std::string name(SymbolRank rank) const { return symbol(rank).get_name(); }
  [[nodiscard]] const Measure& measure(SymbolRank rank) const { return entries_[rank].measure; }
  /// The value of a constant, by its name; empty for any other symbol.
  [[nodiscard]] std::optional<GiNaC::numeric> constant(const std::string& name) const;
  /// The value of an expression in constants only; empty for any other expression.
  [[nodiscard]] std::optional<GiNaC::numeric> number(const GiNaC::ex& expression) const;

 private:
  struct Entry {
    GiNaC::symbol symbol;
    Measure measure;
  };
  std::map<std::string, SymbolRank> ranks_;
  text::Table<SymbolRank, Entry> entries_;
  std::map<std::string, GiNaC::numeric> constants_;
  GiNaC::exmap values_;  ///< the constants by their symbols
};

/// Ranks the symbols of equations: unknowns, dimensions, inputs, rates, others that are `given`,
/// then named quantities, then the `known` ones.
[[nodiscard]] SymbolOrder symbol_order(const equations::ImplicitEquations& equations,
                                       const equations::Vocabulary& vocabulary,
                                       const std::vector<equations::NamedQuantity>& known = {},
                                       const std::vector<GiNaC::symbol>& given = {});

}  // namespace assur::generator::program
