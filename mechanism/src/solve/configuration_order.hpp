// Turns assembly configurations into an order that depends on the mechanism alone.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <vector>

namespace assur::mechanism::solve {

/// Orders configurations by what depends neither on where the mechanism stands, nor on its size,
/// nor on the order in which its parts are listed: sums over all pairs of links that groups place
/// of the cosines of the angles between them, which do not depend on reflection either. Equal sums
/// fall back on sines, on the links' angles by name, and on displacements.
void put_in_order(std::vector<Configuration>& configurations, const NamedParts& parts);

}  // namespace assur::mechanism::solve
