// Reported configuration from the placement of all links.
#pragma once

#include "placement.hpp"

namespace assur::mechanism::solve {

/// Overwrites all of `result` except for `within_limits` and `is_consistent`, which the caller
/// sets.
void write_configuration(const Placement& placement, bool finds_motions, Configuration& result);

}  // namespace assur::mechanism::solve
