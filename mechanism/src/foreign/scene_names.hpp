// Turns the names that another program's file gives into names that a scene can use, each once.
#pragma once

#include <set>
#include <string>

#include "foreign/foreign_mechanism.hpp"

namespace assur::mechanism::foreign {

/// The names of a mechanism's parts in its scene. A part keeps the name that the file gives it if a
/// scene can use it and no other part of its kind is called so; otherwise its name is its
/// identifier, behind the name where several parts share it.
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
  /// Whether the scene names the joint only by its point: a pin of the ground and one link.
  [[nodiscard]] bool is_implied(ForeignJointIndex joint) const { return implied_[joint]; }
  /// The parameter that is the coordinate of a joint as drawn: `A_drawn`.
  [[nodiscard]] const std::string& coordinate(ForeignJointIndex joint) const {
    return coordinates_[joint];
  }
  /// A name for a further point of the scene, made of these words.
  [[nodiscard]] std::string new_point(const std::string& words);

 private:
  void name_joints(const ForeignMechanism& mechanism);

  Table<ForeignPointIndex, std::string> points_;
  Table<ForeignLinkIndex, std::string> links_;
  Table<ForeignJointIndex, std::string> joints_, coordinates_;
  Table<ForeignJointIndex, bool> implied_;
  std::set<std::string> taken_points_;
};

/// The name with underscores behind it until it is not among those taken, to which it is added.
[[nodiscard]] std::string new_name(std::string name, std::set<std::string>& taken);

}  // namespace assur::mechanism::foreign
