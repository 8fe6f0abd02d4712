// Turns the links that no driver places into a group of known structure: kind, model and roles.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/mechanism.hpp"
#include "structure/kind.hpp"

namespace assur::generator {

/// Which links and joints of a mechanism play those of a group, by their indices in the group.
struct RoleAssignment {
  std::vector<int> links;
  std::vector<int> joints;
};

/// A group found in a mechanism.
struct FoundGroup {
  const Model* model;
  Kind kind;  ///< as spelled by the scene's order of links and joints
  /// Assignments under which the kind is the model's representative, in a fixed order.
  std::vector<RoleAssignment> assignments;
};

/// The group that `moving` links form with `joints`, all others being placed; nothing if none of
/// the known groups has this graph. The kind is spelled from the first of the group's links in the
/// scene's order, and then from its first joints.
[[nodiscard]] std::optional<FoundGroup> find_group(const Mechanism& mechanism,
                                                   const std::vector<int>& moving,
                                                   const std::vector<int>& joints);

/// Assur's class of a group: the number of joints on its largest closed contour, where a link of
/// three joints or more is a contour of its own; two if it has none.
[[nodiscard]] int assur_class_of(const Mechanism& mechanism, const std::vector<int>& moving,
                                 const std::vector<int>& joints);

}  // namespace assur::generator
