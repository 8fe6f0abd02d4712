#include "plan_data.hpp"

#include <utility>

namespace assur::mechanism::plan {

PlanData plan_of(const Mechanism& mechanism, const Request& request, Structure structure,
                 const std::vector<FeatureIndex>& more) {
  EvaluationOrder order = evaluation_order(mechanism, request, more);
  NamedParts parts = structure.named_parts(mechanism);
  return {mechanism, request, std::move(structure), std::move(order), std::move(parts), {}, {}, {}};
}

}  // namespace assur::mechanism::plan
