// Turns the dyads of a mechanism that have three pins into their transmission angles.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/structure.hpp>
#include <assur/mechanism/values.hpp>
#include <vector>

namespace assur::mechanism::draw {

/// Two links that a pin joins, each with another pin on the links that hold the dyad.
struct PinnedDyad {
  ElementaryJoint inner, one, other;
};

/// The groups of two links and three pins, in the order in which they are placed.
[[nodiscard]] std::vector<PinnedDyad> dyads_of_pins(const Structure& structure);

/// The angle at the inner pin between the lines to the outer pins, in radians from 0 to pi: force
/// goes from one link to the other best at pi/2, and not at all at 0 and pi.
[[nodiscard]] double transmission_angle(const PinnedDyad& dyad, const Values& values,
                                        const Configuration& configuration);

}  // namespace assur::mechanism::draw
