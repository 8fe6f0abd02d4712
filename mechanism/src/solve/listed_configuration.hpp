// Turns the placement of all links into the configuration that is reported.
#pragma once

#include "placement.hpp"

namespace assur::mechanism::solve {

/// Overwrites all of `result` except for `within_limits` and `is_consistent`, which the caller
/// decides.
void write_configuration(const Placement& placement, bool finds_motions, Configuration& result);

}  // namespace assur::mechanism::solve
