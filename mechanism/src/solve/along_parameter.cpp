#include "along_parameter.hpp"

#include <algorithm>

#include "models/series_functions.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

AlongParameter::AlongParameter(const Values& values, ParameterIndex parameter) : values_(values) {
  const PlanData& plan = values.plan();
  parameters_.resize(plan.mechanism.parameters().size());
  for (const ParameterIndex index : plan.evaluation.parameters) {
    const bool is_replaced = std::ranges::any_of(
        values.replaced(), [index](const auto& entry) { return entry.first == index; });
    parameters_[index] =
        is_replaced ? models::Series() : number(plan.mechanism.parameters()[index].value);
    parameters_[index].c[0] = values.parameter(index);
    parameters_[index].c[1] += index == parameter ? 1 : 0;
  }
  laws_.resize(plan.mechanism.drivers().size());
  for (const DriverIndex driver : plan.evaluation.drivers) {
    laws_[driver] = law(driver);
  }
}

models::Series AlongParameter::number(NumberIndex index) const {
  return values_.plan().mechanism.numbers()[index].formula.evaluate<models::Series>(
      [this](ParameterIndex parameter) { return parameters_[parameter]; });
}

models::Series AlongParameter::law(DriverIndex driver) const {
  const PlanData& plan = values_.plan();
  const NumberIndex position = plan.mechanism.drivers()[driver].position;
  if (!plan.evaluation.reads_links[driver]) {
    return plan.mechanism.numbers()[position].formula.evaluate<models::Series>(
        [this](ParameterIndex parameter) { return parameters_[parameter]; },
        [&](JointIndex joint) { return laws_[plan.mechanism.driver_of(joint)]; });
  }
  return values_.motion(driver).position.value();
}

}  // namespace assur::mechanism::solve
