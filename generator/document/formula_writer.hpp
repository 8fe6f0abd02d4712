// Prints polynomials in the syntax of scene files, the same in every process.
#pragma once

#include <map>
#include <string>

#include "equations/closure.hpp"
#include "program/polynomial.hpp"

namespace assur::generator::document {

/// Prints expressions in the symbols of a model: `2*BC*cos(theta_BCG) - x_B`. Terms and factors are
/// in order of declaration, lengths before directions before rates.
class FormulaWriter {
 public:
  explicit FormulaWriter(const equations::ClosureEquations& equations);

  /// Ranks one more symbol after all others; it is printed by its name.
  void declare(const GiNaC::symbol& symbol) { order_.declare(symbol); }
  [[nodiscard]] std::string operator()(const GiNaC::ex& expression) const;

 private:
  struct Spelled {
    std::string text;
    int place;  ///< position in a product: lengths and quantities 0, directions 1, rates 2
  };

  [[nodiscard]] Spelled spelled(program::SymbolRank rank) const;
  [[nodiscard]] std::string term(const program::Monomial& monomial,
                                 const GiNaC::numeric& size) const;

  program::SymbolOrder order_;
  std::map<std::string, Spelled> spellings_;
};

}  // namespace assur::generator::document
