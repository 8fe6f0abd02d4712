// Order of the motions through one configuration, independent of the scene's listing.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <vector>

namespace assur::mechanism::solve {

/// Sorts branches by the first rates, in the order of names, that differ by more than rounding:
/// angular velocities, velocities of slides, and then their accelerations.
void put_in_order(const NamedParts& parts, std::vector<Configuration>& branches);

}  // namespace assur::mechanism::solve
