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
  /// The mechanism with all constraints, where others may be left out in place of these; else null.
  std::shared_ptr<const plan::Described> described;
};

}  // namespace assur::mechanism
