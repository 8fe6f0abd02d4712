// Turns the parameters of a mechanism into the order in which their formulas can be evaluated.
#pragma once

#include <assur/mechanism/mechanism.hpp>
#include <vector>

namespace assur::mechanism::description {

/// All parameters, each behind those that its formula names. Throws MechanismError for a parameter
/// that has no value, or that depends on itself.
[[nodiscard]] std::vector<ParameterIndex> parameter_order(const Mechanism& mechanism);

}  // namespace assur::mechanism::description
