// Turns links that are placed, all of them, into the configuration that is reported.
#pragma once

#include "placement.hpp"

namespace assur::mechanism::solve {

/// Writes over whatever `result` holds, but for whether limits and redundant constraints are kept.
void write_configuration(const Placement& placement, Configuration& result);

}  // namespace assur::mechanism::solve
