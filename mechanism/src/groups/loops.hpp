// The angles and the independent loops of an Assur group with any number of links.
#pragma once

#include <assur/model_tables.hpp>
#include <optional>
#include <vector>

namespace assur::mechanism::groups {

/// A link that a joint ties to another one, or to the base, which comes before it.
struct Reached {
  int link;
  int joint;
};

/// The graph of a group: which links have one angle, how each link is reached from the base, and
/// which joints close a loop. A group of 2l links has l loops.
struct Loops {
  int link_count;
  std::vector<ModelJoint> joints;
  std::vector<int> angle;  ///< of each link: 0 that of the base, 1 and more those of the group
  int angle_count;         ///< without the base's
  std::vector<int> slide;  ///< the place of each joint among the displacements; -1 of a pin
  int slide_count;
  std::vector<Reached> turned;   ///< links whose angles slides tie to one that is known before
  std::vector<int> free_turned;  ///< for each angle but the base's: the link that it belongs to
  std::vector<Reached> placed;   ///< every link, after the one that the joint ties it to
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

/// The angle along which each displacement runs, as the second link of its joint sees it.
[[nodiscard]] std::vector<int> slide_angles_of(const Loops& loops);

/// The loops of a group of joints among the links 0 .. link_count - 1 and the base. Nothing where
/// slides tie links to one another, or to the base, in a circle: the group cannot be rigid.
[[nodiscard]] std::optional<Loops> loops_of(int link_count, std::vector<ModelJoint> joints);

}  // namespace assur::mechanism::groups
