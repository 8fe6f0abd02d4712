// Turns GiNaC expressions into polynomials in an order of our own, the same in every process.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace assur::generator {

/// Ranks symbols by the order in which they were declared. GiNaC orders by addresses, which differ
/// from run to run; nothing that is printed may depend on them.
class SymbolOrder {
 public:
  /// Declares a symbol; a name declared twice keeps its first rank.
  void declare(const GiNaC::symbol& symbol);
  /// The rank of a declared symbol; throws GeneratorError for any other.
  [[nodiscard]] int rank(const GiNaC::symbol& symbol) const;
  [[nodiscard]] const std::string& name(int rank) const {
    return names_[static_cast<std::size_t>(rank)];
  }
  [[nodiscard]] int size() const { return static_cast<int>(names_.size()); }

 private:
  std::map<std::string, int> ranks_;
  std::vector<std::string> names_;
};

/// A product of symbols, by ascending rank, a square as the rank twice.
using Monomial = std::vector<int>;

/// A polynomial: coefficients by monomial, in lexicographic order of the ranks.
using Polynomial = std::map<Monomial, GiNaC::numeric>;

/// The polynomial that an expression is; throws GeneratorError if it is none.
[[nodiscard]] Polynomial polynomial(const GiNaC::ex& expression, const SymbolOrder& order);

}  // namespace assur::generator
