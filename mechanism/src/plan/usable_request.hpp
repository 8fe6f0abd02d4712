// Checks that a mechanism has everything that a request names.
#pragma once

#include <assur/mechanism/request.hpp>

namespace assur::mechanism::plan {

/// Throws MechanismError if a request names a part that the mechanism does not have, or reports a
/// joint that does not slide, and if there are too many parameters for the requested results.
void expect_usable(const Mechanism& mechanism, const Request& request);

}  // namespace assur::mechanism::plan
