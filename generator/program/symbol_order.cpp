#include "program/symbol_order.hpp"

#include "error.hpp"
#include "program/polynomial.hpp"

namespace assur::generator::program {

void SymbolOrder::declare(const GiNaC::symbol& symbol, Measure measure) {
  const auto [entry, fresh] = ranks_.try_emplace(symbol.get_name());
  if (fresh) {
    entry->second = entries_.add({symbol, measure});
  }
}

void SymbolOrder::set_constant(const GiNaC::symbol& symbol, const GiNaC::numeric& value) {
  constants_[symbol.get_name()] = value;
  values_[symbol] = value;
}

std::optional<GiNaC::numeric> SymbolOrder::constant(const std::string& name) const {
  const auto found = constants_.find(name);
  return found == constants_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<GiNaC::numeric> SymbolOrder::number(const GiNaC::ex& expression) const {
  if (GiNaC::is_a<GiNaC::numeric>(expression)) {
    return GiNaC::ex_to<GiNaC::numeric>(expression);
  }
  if (values_.empty()) {
    return std::nullopt;
  }
  const GiNaC::ex value = expression.subs(values_, GiNaC::subs_options::no_pattern).expand();
  return GiNaC::is_a<GiNaC::numeric>(value) ? std::optional(GiNaC::ex_to<GiNaC::numeric>(value))
                                            : std::nullopt;
}

SymbolRank SymbolOrder::rank(const GiNaC::symbol& symbol) const {
  const auto found = ranks_.find(symbol.get_name());
  if (found == ranks_.end()) {
    throw GeneratorError("program", "symbol order", "undeclared symbol " + symbol.get_name());
  }
  return found->second;
}

namespace {

/// The measure of a quantity, from the last term of its definition.
Measure measure_of(const equations::NamedQuantity& quantity, const SymbolOrder& order) {
  const Polynomial definition = polynomial(quantity.definition, order);
  Measure measure;
  if (!definition.empty()) {
    for (const SymbolRank factor : definition.rbegin()->first) {
      measure.length += order.measure(factor).length;
      measure.time += order.measure(factor).time;
    }
  }
  switch (quantity.form) {
    case equations::NamedQuantity::Form::reciprocal:
      return {-measure.length, -measure.time};
    case equations::NamedQuantity::Form::square_root:
      return {measure.length / 2, measure.time / 2};
    case equations::NamedQuantity::Form::itself:
      break;
  }
  return measure;
}

}  // namespace

SymbolOrder symbol_order(const equations::ImplicitEquations& equations,
                         const equations::Vocabulary& vocabulary,
                         const std::vector<equations::NamedQuantity>& known,
                         const std::vector<GiNaC::symbol>& given) {
  constexpr Measure length{1, 0};
  constexpr Measure direction{0, 0};
  SymbolOrder order;
  const auto lists = {&equations.unknowns, &equations.dimensions, &equations.inputs};
  for (const std::deque<equations::Variable>* list : lists) {
    for (const equations::Variable& variable : *list) {
      if (variable.is_angle()) {
        order.declare(variable.cosine, direction);
        order.declare(variable.sine, direction);
      } else {
        order.declare(variable.value, length);
        order.declare(variable.size, length);
      }
    }
  }
  for (const std::deque<equations::Variable>* list : lists) {
    for (const equations::Variable& variable : *list) {
      const int dimension = variable.is_angle() ? 0 : 1;
      order.declare(variable.rate, {dimension, -1});
      order.declare(variable.second_rate, {dimension, -2});
      order.declare(variable.third_rate, {dimension, -3});
    }
  }
  for (const GiNaC::symbol& symbol : given) {
    order.declare(symbol);
  }
  for (const auto* list : {&vocabulary.quantities(), &known}) {
    for (const equations::NamedQuantity& quantity : *list) {
      order.declare(quantity.symbol, measure_of(quantity, order));
    }
  }
  return order;
}

}  // namespace assur::generator::program
