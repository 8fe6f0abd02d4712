#include "program/symbol_order.hpp"

#include "error.hpp"

namespace assur::generator::program {

void SymbolOrder::declare(const GiNaC::symbol& symbol) {
  const auto [entry, fresh] = ranks_.try_emplace(symbol.get_name());
  if (fresh) {
    entry->second = names_.add(symbol.get_name());
  }
}

SymbolRank SymbolOrder::rank(const GiNaC::symbol& symbol) const {
  const auto found = ranks_.find(symbol.get_name());
  if (found == ranks_.end()) {
    throw GeneratorError("program", "symbol order", "undeclared symbol " + symbol.get_name());
  }
  return found->second;
}

SymbolOrder symbol_order(const equations::ImplicitEquations& equations,
                         const equations::Vocabulary& vocabulary) {
  SymbolOrder order;
  const auto lists = {&equations.unknowns, &equations.dimensions, &equations.inputs};
  for (const std::deque<equations::Variable>* list : lists) {
    for (const equations::Variable& variable : *list) {
      if (variable.is_angle()) {
        order.declare(variable.cosine);
        order.declare(variable.sine);
      } else {
        order.declare(variable.value);
        order.declare(variable.size);
      }
    }
  }
  for (const std::deque<equations::Variable>* list : lists) {
    for (const equations::Variable& variable : *list) {
      order.declare(variable.rate);
      order.declare(variable.second_rate);
      order.declare(variable.third_rate);
    }
  }
  for (const equations::NamedQuantity& quantity : vocabulary.quantities()) {
    order.declare(quantity.symbol);
  }
  return order;
}

}  // namespace assur::generator::program
