// Turns the order in which links are placed into the one in which the forces of joints are found.
#pragma once

#include <assur/mechanism/structure.hpp>
#include <vector>

namespace assur::generator::emission::scene {

/// A group whose joints' forces are found, or a driver that is cut.
struct ForceStep {
  mechanism::GroupIndex group;                  ///< does not exist where a driver is cut
  const mechanism::CarriedLink* cut = nullptr;  ///< null for a group
};

/// The link and all links that it carries, which count as one of a group's links.
[[nodiscard]] std::vector<mechanism::LinkIndex> links_carried_by(
    const mechanism::Structure& structure, mechanism::LinkIndex link);

/// All groups and drivers, each behind those on its far side, and behind the drivers whose laws
/// read joints there. The structure must outlive the steps.
[[nodiscard]] std::vector<ForceStep> force_order(const mechanism::Mechanism& mechanism,
                                                 const mechanism::Structure& structure);

}  // namespace assur::generator::emission::scene
