// Turns a mechanism and a request into the orders of placement and evaluation that all solving
// shares.
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

/// What is planned once: the mechanism, what is wanted of it, the order of its links and formulas.
struct PlanData {
  Mechanism mechanism;
  Request request;
  Structure structure;
  plan::EvaluationOrder evaluation;
  NamedParts named_parts;
  /// Joints that hold beside those of the structure, and the error to report where they do not.
  std::vector<RedundantJoint> redundant;
  std::optional<OverConstrained> excess;
  /// The plans that leave out others in place of these; null where these are the only ones tried.
  std::shared_ptr<const plan::OtherPlans> others;
};

}  // namespace assur::mechanism

namespace assur::mechanism::plan {

/// The plan of a mechanism with a structure. `more` are features that are evaluated beside those
/// that the structure and the request read. Throws MechanismError where formulas go round in a
/// circle.
[[nodiscard]] PlanData plan_of(const Mechanism& mechanism, const Request& request,
                               Structure structure, const std::vector<FeatureIndex>& more = {});

}  // namespace assur::mechanism::plan
