// Revolute joints implied by points that several links list.
#pragma once

#include <assur/mechanism/drawn_mechanism.hpp>
#include <vector>

namespace assur::mechanism::drawn {

/// A revolute joint at a point, of one link from each set of links that are joined there already,
/// the ground first, then by name.
struct ImpliedPin {
  DrawnPointIndex point;
  std::vector<DrawnLinkIndex> links;
};

/// The pins at all points. At each point, the links that list it are joined, except a link whose
/// slot has an explicit pin there. Throws MechanismError if an explicit joint has the name that a
/// pin needs.
[[nodiscard]] std::vector<ImpliedPin> implied_pins(const DrawnParts& parts,
                                                   const std::vector<DrawnJoint>& joints);

}  // namespace assur::mechanism::drawn
