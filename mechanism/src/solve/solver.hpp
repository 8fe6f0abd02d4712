// Turns the values of a planned mechanism into every assembly configuration.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>

#include "plan/plan_data.hpp"

namespace assur::mechanism {

/// See `Plan::solve`.
[[nodiscard]] Solution solve(const std::shared_ptr<const PlanData>& plan, const Values& values);

}  // namespace assur::mechanism
