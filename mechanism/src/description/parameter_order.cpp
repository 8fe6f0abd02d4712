#include "description/parameter_order.hpp"

#include "description/order_of_needs.hpp"

namespace assur::mechanism::description {

std::vector<ParameterIndex> parameter_order(const Mechanism& mechanism) {
  const Table<ParameterIndex, Parameter>& parameters = mechanism.parameters();
  const auto needed_by = [&](ParameterIndex index) {
    const Parameter& parameter = parameters[index];
    if (!parameter.value.exists()) {
      throw MechanismError("parameters." + parameter.name,
                           "the parameter has no value; give it one");
    }
    return mechanism.numbers()[parameter.value].formula.parameters();
  };
  const auto refuse = [&](const std::vector<ParameterIndex>& circle) {
    throw MechanismError(mechanism.numbers()[parameters[circle[0]].value].part,
                         "the parameter depends on itself" +
                             (circle.size() == 1 ? "; its formula may not name it"
                                                 : " through '" + parameters[circle[1]].name +
                                                       "'; give one of them a number"));
  };
  return order_of_needs<ParameterIndex>(parameters.size(), needed_by, refuse);
}

}  // namespace assur::mechanism::description
