// Turns a mechanism with constraints that are too many, but hold, into a plan without them.
#pragma once

#include <assur/mechanism/error.hpp>
#include <assur/mechanism/request.hpp>
#include <memory>
#include <vector>

#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

/// Of a mechanism all of which is modelled. `more`: features that are evaluated beside those that
/// the structure and the request read.
[[nodiscard]] std::shared_ptr<const PlanData> planned_whole(
    const Mechanism& mechanism, const Request& request, Structure structure,
    const std::vector<FeatureIndex>& more = {});

/// Of a mechanism with constraints that hold where the others do. Without whole joints its groups
/// are the smallest, but they may move freely where the mechanism does not, as a coupler does on
/// parallel cranks. Throws OverConstrained where they hold in no way in which they can be left out.
[[nodiscard]] std::shared_ptr<const PlanData> planned_with_redundancy(
    const Mechanism& mechanism, const Request& request, const OverConstrained& excess);

/// The same mechanism without others of its constraints: those plans first that have the joints
/// that this one does without. Nothing is known of whether what they leave out holds.
[[nodiscard]] std::vector<std::shared_ptr<const PlanData>> other_plans(const PlanData& plan);

}  // namespace assur::mechanism::solve
