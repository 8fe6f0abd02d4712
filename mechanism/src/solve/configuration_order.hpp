// Turns assembly configurations into an order that depends on the mechanism alone.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <vector>

namespace assur::mechanism {

/// Orders configurations by what depends neither on where the mechanism stands, nor on how it is
/// reflected, nor on the order in which its parts are listed: sums over all pairs of `moving` links
/// of the cosines of the angles between them. Equal sums fall back on sines and displacements.
void put_in_order(std::vector<Configuration>& configurations, const std::vector<LinkIndex>& moving);

}  // namespace assur::mechanism
