#include "drawn/own_values.hpp"

#include <cmath>

#include "description/parameter_order.hpp"

namespace assur::mechanism::drawn {

OwnValues::OwnValues(const Mechanism& mechanism) : parameters_(mechanism.parameters().size()) {
  for (const ParameterIndex parameter : description::parameter_order(mechanism)) {
    const Number& value = mechanism.numbers()[mechanism.parameters()[parameter].value];
    parameters_[parameter] = of(value.formula, value.part);
  }
}

double OwnValues::of(const Formula& formula, const std::string& part) const {
  const auto value =
      formula.evaluate<double>([this](ParameterIndex parameter) { return parameters_[parameter]; });
  if (!std::isfinite(value)) {
    throw MechanismError(part, "the value is not a finite number");
  }
  return value;
}

}  // namespace assur::mechanism::drawn
