// Turns a configuration into whether joints beyond those that determine it hold.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>

namespace assur::mechanism::solve {

/// Whether the redundant joints of a plan hold to rounding, or to the tolerance that the request
/// states, and whether their rates do where these are known.
[[nodiscard]] bool holds_redundantly(const Values& values, const Configuration& configuration);

/// Leaves out the configurations in which they do not. Throws OverConstrained if none is left.
void leave_out_inconsistent(const PlanData& plan, Solution& solution);

}  // namespace assur::mechanism::solve
