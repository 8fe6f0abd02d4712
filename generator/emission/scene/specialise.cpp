#include "emission/scene/specialise.hpp"

#include <assur/text/error.hpp>
#include <cmath>
#include <limits>

namespace assur::generator::emission::scene {

namespace {

bool is_number(const GiNaC::ex& expression) { return GiNaC::is_a<GiNaC::numeric>(expression); }

bool needs_no_name(const GiNaC::ex& expression) {
  return is_number(expression) || GiNaC::is_a<GiNaC::symbol>(expression) ||
         GiNaC::is_a<GiNaC::symbol>(-expression);
}

}  // namespace

NamedResults specialised(const std::vector<equations::NamedQuantity>& quantities,
                         const std::vector<program::Result>& results, GiNaC::exmap values) {
  const auto folded = [&values](const GiNaC::ex& expression) {
    return expression.subs(values, GiNaC::subs_options::no_pattern).expand();
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
    if (itself ? needs_no_name(definition) : reciprocal && is_number(definition)) {
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
