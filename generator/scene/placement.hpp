// Turns a scene into the order in which its links are placed: the driven links, then the groups.
#pragma once

#include <string>
#include <vector>

#include "scene/grouping.hpp"

namespace assur::generator {

/// A link that a driver moves against one that is placed before.
struct DrivenLink {
  int driver;  ///< of the scene
  int joint;   ///< of the mechanism
  int from, to;
};

struct PlacementOrder {
  Mechanism mechanism;  ///< with every pin of several links as joints of two
  std::vector<DrivenLink> driven;
  std::vector<FoundGroup> groups;
  std::vector<std::vector<std::string>> group_links;  ///< in the order of the scene

  /// For each link of the mechanism whether it is the ground or driven: no group places it.
  [[nodiscard]] std::vector<bool> placed_by_drivers() const;
};

/// Throws InputError for a scene that is over- or under-constrained, that has no ground, or that
/// holds a group that is not known.
[[nodiscard]] PlacementOrder placement_order(const Scene& scene, const ParameterValues& values);

}  // namespace assur::generator
