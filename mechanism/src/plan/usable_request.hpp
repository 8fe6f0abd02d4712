// Turns a request into the error that says what in it a mechanism does not have.
#pragma once

#include <assur/mechanism/request.hpp>

namespace assur::mechanism::plan {

/// Throws MechanismError where a request names what the mechanism does not have, or reports a joint
/// that does not slide, and where there are more parameters than what is wanted allows.
void expect_usable(const Mechanism& mechanism, const Request& request);

}  // namespace assur::mechanism::plan
