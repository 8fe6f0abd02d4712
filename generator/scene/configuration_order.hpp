// Turns assembly configurations into an order that depends on the mechanism alone.
#pragma once

#include <vector>

#include "scene/solve.hpp"

namespace assur::generator {

/// Orders configurations by what depends neither on where the mechanism stands, nor on how it is
/// reflected, nor on the order in which the scene lists it: sums over all pairs of `moving` links
/// of the cosines of the angles between them. Equal sums fall back on sines and displacements.
void put_in_order(std::vector<AssemblyConfiguration>& configurations,
                  const std::vector<bool>& moving);

}  // namespace assur::generator
