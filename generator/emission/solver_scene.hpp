// Turns a scene into what the text of its solver is made from: values, order and names.
#pragma once

#include <string>
#include <vector>

#include "emission/scene_lines.hpp"
#include "scene/placement.hpp"

namespace assur::generator {

/// The members that stand for what the scene names, each list in the order of the scene.
struct SceneMembers {
  std::vector<std::string> links, joints, drivers, outputs;
};

/// A scene as its solver sees it. The scene must outlive it.
struct SolverScene {
  /// Throws InputError for a scene that cannot be taken apart into known groups.
  explicit SolverScene(const Scene& described);

  const Scene& scene;
  ParameterValues values;
  PlacementOrder order;
  ModelledParameters parameters;
  SceneMembers members;
  int derivative_order;   ///< of the time derivatives that are wanted: 0, 1 or 2
  std::string file;       ///< without directories
  std::string structure;  ///< the name of the solver's struct

  [[nodiscard]] const MechanismJoint& joint(int index) const {
    return order.mechanism.joints[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] const std::string& link_name(int link) const {
    return order.mechanism.links[static_cast<std::size_t>(link)];
  }
  [[nodiscard]] bool is_ground(int link) const { return link == order.mechanism.ground; }
  /// Whether the scene lists the link; the block of a pin in a slot it does not.
  [[nodiscard]] bool lists(int link) const { return link < static_cast<int>(scene.links.size()); }
  /// `placed.crank`, or nothing for the ground, which is the frame of all.
  [[nodiscard]] std::string placed(int link) const {
    return is_ground(link) ? "" : "placed." + members.links[static_cast<std::size_t>(link)];
  }
  [[nodiscard]] const std::string& slide_member(const MechanismJoint& at) const {
    return members.joints[static_cast<std::size_t>(at.scene_joint)];
  }
};

}  // namespace assur::generator
