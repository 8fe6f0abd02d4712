// Order in which the formulas of a mechanism's parameters can be evaluated.
#pragma once

#include <assur/mechanism/mechanism.hpp>
#include <vector>

namespace assur::mechanism::description {

/// All parameters, each after those in its formula. Throws MechanismError for a parameter without a
/// value, or one that depends on itself.
[[nodiscard]] std::vector<ParameterIndex> parameter_order(const Mechanism& mechanism);

}  // namespace assur::mechanism::description
