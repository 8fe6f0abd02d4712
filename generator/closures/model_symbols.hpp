// Turns a kinematic model of the generator into the symbols and closures of an audit.
#pragma once

#include "closures/closure_system.hpp"

namespace assur::generator::closures {

/// Declares the variables of the kind's model under their own names, the unknowns as unknown and
/// the inputs as moving, and its scalar closures as f1, f2, ... Throws InputError if no group has
/// the kind.
void declare_model(const std::string& kind, ClosureSystem& system);

}  // namespace assur::generator::closures
