#include "program/polynomial.hpp"

#include <algorithm>
#include <iterator>

#include "error.hpp"

namespace assur::generator::program {

namespace {

[[noreturn]] void not_a_polynomial(const GiNaC::ex& part) {
  std::ostringstream text;
  text << part;
  throw GeneratorError("program", "polynomial", "not a polynomial: " + text.str());
}

void add_term(Polynomial& sum, const GiNaC::ex& term, const SymbolOrder& order) {
  Coefficient coefficient = 1;
  Monomial monomial;
  const auto multiply = [&](const GiNaC::ex& factor) {
    if (const std::optional<GiNaC::numeric> number = order.number(factor)) {
      coefficient *= Coefficient(*number, factor);
    } else if (GiNaC::is_a<GiNaC::symbol>(factor)) {
      monomial.push_back(order.rank(GiNaC::ex_to<GiNaC::symbol>(factor)));
    } else if (GiNaC::is_a<GiNaC::power>(factor) && GiNaC::is_a<GiNaC::symbol>(factor.op(0)) &&
               factor.op(1).info(GiNaC::info_flags::posint)) {
      std::fill_n(std::back_inserter(monomial), GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int(),
                  order.rank(GiNaC::ex_to<GiNaC::symbol>(factor.op(0))));
    } else {
      not_a_polynomial(factor);
    }
  };
  if (GiNaC::is_a<GiNaC::mul>(term)) {
    for (const GiNaC::ex& factor : term) {
      multiply(factor);
    }
  } else {
    multiply(term);
  }
  std::sort(monomial.begin(), monomial.end());
  sum[monomial] += coefficient;
}

}  // namespace

Polynomial polynomial(const GiNaC::ex& expression, const SymbolOrder& order) {
  const GiNaC::ex expanded = expression.expand();
  Polynomial sum;
  if (GiNaC::is_a<GiNaC::add>(expanded)) {
    for (const GiNaC::ex& term : expanded) {
      add_term(sum, term, order);
    }
  } else {
    add_term(sum, expanded, order);
  }
  std::erase_if(sum, [](const auto& term) { return term.second.is_zero(); });
  return sum;
}

GiNaC::ex expression(const Polynomial& polynomial, const SymbolOrder& order) {
  GiNaC::ex sum;
  for (const auto& [monomial, coefficient] : polynomial) {
    GiNaC::ex term = coefficient.origin();
    for (const SymbolRank symbol : monomial) {
      term *= order.symbol(symbol);
    }
    sum += term;
  }
  return sum;
}

}  // namespace assur::generator::program
