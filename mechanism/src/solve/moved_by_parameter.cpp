#include "moved_by_parameter.hpp"

#include "plan/plan_data.hpp"
#include "values/group_numbers.hpp"

namespace assur::mechanism::solve {

bool moves_drivers_alone(const Values& values, Eigen::Index column) {
  const PlanData& plan = values.plan();
  for (const FeatureIndex feature : plan.mechanism.features().keys()) {
    const auto& follows = values.frame(feature).follows.first;
    if (follows.cols() > column && !follows.col(column).isZero(0)) {
      return false;
    }
  }
  for (const GroupIndex group : plan.structure.groups.keys()) {
    for (const values::DimensionDerivative& entry : values.numbers_of(group).nonzero_of_d) {
      if (entry.parameter == column && entry.value != 0) {
        return false;
      }
    }
    for (const values::AcrossAxis& axis : values.numbers_of(group).across) {
      if (axis.first(column) != 0) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace assur::mechanism::solve
