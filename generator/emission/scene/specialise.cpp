#include "emission/scene/specialise.hpp"

#include <assur/text/error.hpp>
#include <cmath>
#include <limits>

namespace assur::generator::emission::scene {

namespace {

bool is_symbol(const GiNaC::ex& expression) {
  return GiNaC::is_a<GiNaC::symbol>(expression) || GiNaC::is_a<GiNaC::symbol>(-expression);
}

}  // namespace

NamedResults specialised(const std::vector<equations::NamedQuantity>& quantities,
                         const std::vector<program::Result>& results,
                         const program::SymbolOrder& order, GiNaC::exmap values) {
  const auto folded = [&](const GiNaC::ex& expression) {
    const GiNaC::ex numbers = expression.subs(values, GiNaC::subs_options::no_pattern);
    return program::expression(program::polynomial(numbers, order), order);
  };
  NamedResults special;
  for (const equations::NamedQuantity& quantity : quantities) {
    const GiNaC::ex definition = folded(quantity.definition);
    const bool reciprocal = quantity.form == equations::NamedQuantity::Form::reciprocal;
    const bool itself = quantity.form == equations::NamedQuantity::Form::itself;
    if (reciprocal && definition.is_zero()) {
      throw text::InputError("the group has no closed form with these dimensions (" +
                             quantity.meaning + ")");
    }
    const bool number = order.number(definition).has_value();
    if (itself ? number || is_symbol(definition) : reciprocal && number) {
      values[quantity.symbol] = reciprocal ? GiNaC::ex(1 / definition) : definition;
    } else {
      special.quantities.push_back(quantity);
      special.quantities.back().definition = definition;
    }
  }
  for (const program::Result& result : results) {
    special.results.push_back({result.target, folded(result.value)});
  }
  return special;
}

}  // namespace assur::generator::emission::scene
