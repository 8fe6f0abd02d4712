// Unique names for a scene, from those in another program's file.
#pragma once

#include <set>
#include <string>

#include "foreign/foreign_mechanism.hpp"

namespace assur::mechanism::foreign {

/// The names of a mechanism's parts in its scene. A part keeps its name from the file if a scene
/// accepts it and no other part of its kind has it; otherwise its name is its identifier, after the
/// shared name if several parts have it.
class SceneNames {
 public:
  /// Adds a remark for each name that cannot be used.
  explicit SceneNames(ForeignMechanism& mechanism);

  [[nodiscard]] const std::string& operator[](ForeignPointIndex point) const {
    return points_[point];
  }
  [[nodiscard]] const std::string& operator[](ForeignLinkIndex link) const { return links_[link]; }
  [[nodiscard]] const std::string& operator[](ForeignJointIndex joint) const {
    return joints_[joint];
  }
  /// Whether the scene names the joint only by its point: a pin between the ground and one link.
  [[nodiscard]] bool is_implied(ForeignJointIndex joint) const { return implied_[joint]; }
  /// The parameter that is the coordinate of a joint as drawn: `A_drawn`.
  [[nodiscard]] const std::string& coordinate(ForeignJointIndex joint) const {
    return coordinates_[joint];
  }
  /// A name for a further point of the scene, composed of these words.
  [[nodiscard]] std::string new_point(const std::string& words);

 private:
  void name_joints(const ForeignMechanism& mechanism);

  Table<ForeignPointIndex, std::string> points_;
  Table<ForeignLinkIndex, std::string> links_;
  Table<ForeignJointIndex, std::string> joints_, coordinates_;
  Table<ForeignJointIndex, bool> implied_;
  std::set<std::string> taken_points_;
};

/// The name, with underscores appended until it is not among those taken, to which it is added.
[[nodiscard]] std::string new_name(std::string name, std::set<std::string>& taken);

}  // namespace assur::mechanism::foreign
