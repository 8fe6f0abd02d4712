// Data of a plan: the orders of placement and evaluation, shared by all solving.
#pragma once

#include <assur/mechanism/request.hpp>
#include <assur/mechanism/structure.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "plan/evaluation_order.hpp"
#include "plan/redundancy.hpp"

namespace assur::mechanism::plan {
class OtherPlans;
}

namespace assur::mechanism {

/// The result of planning: the mechanism, the request, and the order of its links and formulas.
struct PlanData {
  Mechanism mechanism;
  Request request;
  Structure structure;
  plan::EvaluationOrder evaluation;
  NamedParts named_parts;
  /// Joints that must hold beside those of the structure, and the error to report if they do not.
  std::vector<RedundantJoint> redundant;
  std::optional<OverConstrained> excess;
  /// The plans with other choices of left-out joints; null if there are none to try.
  std::shared_ptr<const plan::OtherPlans> others;
};

}  // namespace assur::mechanism

namespace assur::mechanism::plan {

/// The plan of a mechanism with a structure. `more` are features to evaluate beside those of the
/// structure and the request. Throws MechanismError if formulas depend on one another in a cycle.
[[nodiscard]] PlanData plan_of(const Mechanism& mechanism, const Request& request,
                               Structure structure, const std::vector<FeatureIndex>& more = {});

}  // namespace assur::mechanism::plan
