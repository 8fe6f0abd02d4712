// Turns a mechanism with excess constraints, if these hold, into a plan without them.
#pragma once

#include <assur/mechanism/error.hpp>
#include <assur/mechanism/request.hpp>
#include <memory>
#include <vector>

#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

/// Returns the plan of a mechanism none of whose constraints is left out. `more` are features that
/// are evaluated beside those that the structure and the request read.
[[nodiscard]] std::shared_ptr<const PlanData> planned_whole(
    const Mechanism& mechanism, const Request& request, Structure structure,
    const std::vector<FeatureIndex>& more = {});

/// Returns the plan of a mechanism without its excess constraints, if these hold where the others
/// do. Whole joints are left out first, since that gives the smallest groups; such groups may move
/// freely where the mechanism does not, as a coupler does on parallel cranks.
/// Throws OverConstrained if no choice of constraints that can be left out is found to hold.
[[nodiscard]] std::shared_ptr<const PlanData> planned_with_redundancy(
    const Mechanism& mechanism, const Request& request, const OverConstrained& excess);

/// Returns the plans of the same mechanism in which other constraints are left out. Those that keep
/// the joints that this plan does without come first. Whether the constraints that they leave out
/// hold is not known.
[[nodiscard]] std::vector<std::shared_ptr<const PlanData>> other_plans(const PlanData& plan);

}  // namespace assur::mechanism::solve
