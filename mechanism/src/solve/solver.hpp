// Turns the values of a planned mechanism into every assembly configuration.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>

#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

/// See `Plan::solve`. On demand a solution without configurations tells by how much the links fail
/// to close, which takes longer than to solve.
void solve(const std::shared_ptr<const PlanData>& plan, const Values& values, bool measure_gap,
           Solution& result);

}  // namespace assur::mechanism::solve
