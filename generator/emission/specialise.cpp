#include "emission/specialise.hpp"

#include <cmath>
#include <limits>

#include "error.hpp"

namespace assur::generator {

namespace {

bool is_number(const GiNaC::ex& expression) { return GiNaC::is_a<GiNaC::numeric>(expression); }

bool needs_no_name(const GiNaC::ex& expression) {
  return is_number(expression) || GiNaC::is_a<GiNaC::symbol>(expression) ||
         GiNaC::is_a<GiNaC::symbol>(-expression);
}

}  // namespace

GiNaC::numeric exact(double value) {
  constexpr int digits = std::numeric_limits<double>::digits;
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  const auto whole = static_cast<long>(std::ldexp(mantissa, digits));
  return GiNaC::numeric(whole) * GiNaC::pow(GiNaC::numeric(2), GiNaC::numeric(exponent - digits));
}

NamedResults specialised(const std::vector<NamedQuantity>& quantities,
                         const std::vector<Result>& results, GiNaC::exmap values) {
  const auto folded = [&values](const GiNaC::ex& expression) {
    return expression.subs(values, GiNaC::subs_options::no_pattern).expand();
  };
  NamedResults special;
  for (const NamedQuantity& quantity : quantities) {
    const GiNaC::ex definition = folded(quantity.definition);
    const bool reciprocal = quantity.form == NamedQuantity::Form::reciprocal;
    const bool itself = quantity.form == NamedQuantity::Form::itself;
    if (reciprocal && definition.is_zero()) {
      throw InputError("the group has no closed form with these dimensions (" + quantity.meaning +
                       ")");
    }
    if (itself ? needs_no_name(definition) : reciprocal && is_number(definition)) {
      values[quantity.symbol] = reciprocal ? GiNaC::ex(1 / definition) : definition;
    } else {
      special.quantities.push_back(quantity);
      special.quantities.back().definition = definition;
    }
  }
  for (const Result& result : results) {
    special.results.push_back({result.target, folded(result.value)});
  }
  return special;
}

}  // namespace assur::generator
