// Turns a mechanism into the order in which its links are placed: driven links, then Assur groups.
#pragma once

#include <assur/mechanism/group_model.hpp>
#include <assur/mechanism/mechanism.hpp>
#include <string>
#include <vector>

namespace assur::mechanism {

/// A joint between two links, revolute or prismatic, with its feature on each; the feature of a
/// block, which has no size, is none.
struct ElementaryJoint {
  std::string name;
  JointIndex joint;  ///< of the mechanism
  bool prismatic;
  LinkIndex first, second;  ///< the displacement runs from first to second
  FeatureIndex on_first, on_second;

  [[nodiscard]] bool joins(LinkIndex one, LinkIndex other) const {
    return (first == one && second == other) || (first == other && second == one);
  }
  [[nodiscard]] bool touches(LinkIndex link) const { return first == link || second == link; }
  [[nodiscard]] LinkIndex other(LinkIndex link) const { return first == link ? second : first; }
  [[nodiscard]] FeatureIndex on(LinkIndex link) const {
    return link == first ? on_first : on_second;
  }
};
using ElementaryJointIndex = Index<ElementaryJoint>;

/// A pin of three links or more. Which two of them each of its k - 1 joints joins is told by the
/// order in which the links are placed.
struct SharedPin {
  std::string name;
  JointIndex joint;
  std::vector<LinkIndex> links;
  std::vector<FeatureIndex> features;  ///< in the order of the links
};

/// A mechanism of elementary joints. A pin in a slot has become a block, a link of no size with a
/// revolute and a prismatic joint, which stands behind the mechanism's own links.
struct Linkage {
  Table<LinkIndex, std::string> links;  ///< their names
  LinkIndex ground;
  Table<ElementaryJointIndex, ElementaryJoint> joints;
  std::vector<SharedPin> pins;
};

[[nodiscard]] Linkage linkage_of(const Mechanism& mechanism);

/// A link that a driver moves against one that is placed before.
struct DrivenLink {
  DriverIndex driver;
  ElementaryJointIndex joint;
  LinkIndex from, to;
};

/// Which links and joints of a linkage play those of a group, by their indices in the group.
struct RoleAssignment {
  std::vector<LinkIndex> links;
  std::vector<ElementaryJointIndex> joints;
};

/// A group found in a mechanism.
struct FoundGroup {
  const GroupModel* model;
  std::string kind;              ///< spelled by the mechanism's order of links and joints
  std::vector<LinkIndex> links;  ///< in the order of the mechanism
  /// Assignments under which the kind is the model's representative, in a fixed order.
  std::vector<RoleAssignment> assignments;
};
using GroupIndex = Index<FoundGroup>;

/// A slide, and whether its displacement runs from the link whose name comes first to the other, 1,
/// or back, -1.
struct NamedSlide {
  JointIndex joint;
  double sense;
};

/// What distinguishes configurations, in an order that does not depend on how the mechanism is
/// listed: that of names.
struct NamedParts {
  std::vector<LinkIndex> links;  ///< that groups place
  std::vector<NamedSlide> slides;
};

/// The order in which the links of a mechanism are placed.
struct Structure {
  Linkage linkage;  ///< with every pin of several links as joints of two
  std::vector<DrivenLink> driven;
  Table<GroupIndex, FoundGroup> groups;

  [[nodiscard]] std::vector<std::string> names_of(const std::vector<LinkIndex>& links) const;
  /// Links and slides in the order of their names.
  [[nodiscard]] NamedParts named_parts(const Mechanism& mechanism) const;
  /// For each link whether it is the ground or driven: no group places it.
  [[nodiscard]] Table<LinkIndex, bool> placed_by_drivers() const;
};

/// Throws MechanismError for a mechanism that is over- or under-constrained, that has no ground, or
/// that holds a group that is not known.
[[nodiscard]] Structure structure_of(const Mechanism& mechanism);

}  // namespace assur::mechanism
