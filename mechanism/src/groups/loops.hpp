// Angles and independent loops of an Assur group with any number of links.
#pragma once

#include <assur/model_tables.hpp>
#include <optional>
#include <vector>

namespace assur::mechanism::groups {

/// A link that a joint connects to the base or to an earlier link.
struct Reached {
  int link;
  int joint;
};

/// The graph of a group: the links of equal angle, the joints by which each link is reached from
/// the base, and the joints that close a loop. A group of 2l links has l loops.
struct Loops {
  int link_count;
  std::vector<ModelJoint> joints;
  std::vector<int> angle;  ///< of each link: 0 that of the base, 1 and more those of the group
  int angle_count;         ///< without the base's
  std::vector<int> slide;  ///< the index of each joint's displacement; -1 for a pin
  int slide_count;
  std::vector<Reached> turned;   ///< links whose angles slides tie to an earlier one
  std::vector<int> free_turned;  ///< for each angle except the base's: its link
  std::vector<Reached> placed;   ///< every link, after the one to which the joint connects it
  std::vector<int> closing;      ///< the joints that close the loops

  [[nodiscard]] int loop_count() const { return static_cast<int>(closing.size()); }
  [[nodiscard]] int angle_of(int link) const {
    return link == base_link ? 0 : angle[static_cast<std::size_t>(link)];
  }
  /// The link on the other side of a joint.
  [[nodiscard]] int other(int joint, int link) const {
    const ModelJoint& at = joints[static_cast<std::size_t>(joint)];
    return at.first == link ? at.second : at.first;
  }
};

/// The angle along which each displacement runs, in the frame of the second link of its joint.
[[nodiscard]] std::vector<int> slide_angles_of(const Loops& loops);

/// The loops of a group of joints among the links 0 .. link_count - 1 and the base. Nothing if
/// slides connect links to one another, or to the base, in a cycle: the group cannot be rigid.
[[nodiscard]] std::optional<Loops> loops_of(int link_count, std::vector<ModelJoint> joints);

}  // namespace assur::mechanism::groups
