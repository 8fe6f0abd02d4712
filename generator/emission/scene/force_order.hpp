// The order in which the joint forces of groups and drivers are found.
#pragma once

#include <assur/mechanism/structure.hpp>
#include <vector>

namespace assur::generator::emission::scene {

/// A group whose joint forces are found, or a driver that is cut.
struct ForceStep {
  mechanism::GroupIndex group;                  ///< does not exist where a driver is cut
  const mechanism::CarriedLink* cut = nullptr;  ///< null for a group
};

/// The link and all links that it carries, which count as one link of a group.
[[nodiscard]] std::vector<mechanism::LinkIndex> links_carried_by(
    const mechanism::Structure& structure, mechanism::LinkIndex link);

/// All groups and drivers, each after those on its far side and after the drivers whose laws read
/// joints there. The structure must outlive the steps.
[[nodiscard]] std::vector<ForceStep> force_order(const mechanism::Mechanism& mechanism,
                                                 const mechanism::Structure& structure);

}  // namespace assur::generator::emission::scene
