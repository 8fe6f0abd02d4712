// Turns a scene at given parameter values into links and joints of two links each.
#pragma once

#include <assur/normal_form.hpp>
#include <string>
#include <vector>

#include "scene/parameters.hpp"

namespace assur::generator {

/// A joint between two links, revolute or prismatic, with its feature on each.
struct MechanismJoint {
  std::string name;
  int scene_joint;
  bool prismatic;
  int first, second;  ///< links; the displacement runs from first to second
  LinkFeature<Dual> on_first, on_second;

  [[nodiscard]] bool joins(int one, int other) const {
    return (first == one && second == other) || (first == other && second == one);
  }
  [[nodiscard]] const LinkFeature<Dual>& on(int link) const {
    return link == first ? on_first : on_second;
  }
};

/// A pin of three links or more. Which two of them each of its k - 1 joints joins is told by the
/// order in which the links are placed.
struct MechanismPin {
  std::string name;
  int scene_joint;
  std::vector<int> links;
  std::vector<LinkFeature<Dual>> features;  ///< in the order of the links
};

/// A mechanism of elementary joints. A pin in a slot has become a link of no size with a revolute
/// and a prismatic joint, which stands behind the scene's links.
struct Mechanism {
  std::vector<std::string> links;
  int ground = -1;  ///< index of the fixed frame, or -1 if the scene names none
  std::vector<MechanismJoint> joints;
  std::vector<MechanismPin> pins;
};

/// Throws InputError for a line whose `along` has no length.
[[nodiscard]] Mechanism mechanism_of(const Scene& scene, const ParameterValues& values);

}  // namespace assur::generator
