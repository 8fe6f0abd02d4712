// Order in which a mechanism's links are placed: carried links and Assur groups.
#pragma once

#include <assur/mechanism/group_model.hpp>
#include <assur/mechanism/mechanism.hpp>
#include <string>
#include <vector>

namespace assur::mechanism {

/// A revolute or prismatic joint between two links, with its feature on each; a block, which has no
/// size, has no feature. In a group, links that drivers or other groups connect rigidly count as
/// one: the joint joins that one, and the feature may belong to a link that it carries.
struct ElementaryJoint {
  std::string name;
  JointIndex joint;  ///< of the mechanism; does not exist between the blocks of two pins in a slot
  bool prismatic;
  LinkIndex first, second;  ///< the displacement runs from first to second
  FeatureIndex on_first, on_second;
  LinkIndex holder_first = first, holder_second = second;  ///< the owners of the features

  [[nodiscard]] bool joins(LinkIndex one, LinkIndex other) const {
    return (first == one && second == other) || (first == other && second == one);
  }
  [[nodiscard]] bool touches(LinkIndex link) const { return first == link || second == link; }
  [[nodiscard]] LinkIndex other(LinkIndex link) const { return first == link ? second : first; }
  [[nodiscard]] FeatureIndex on(LinkIndex link) const {
    return link == first ? on_first : on_second;
  }
  [[nodiscard]] LinkIndex holder(LinkIndex link) const {
    return link == first ? holder_first : holder_second;
  }
};
using ElementaryJointIndex = Index<ElementaryJoint>;

/// A pin of three links or more. The pairs of links that its k - 1 joints connect depend on the
/// order in which the links are placed.
struct SharedPin {
  std::string name;
  JointIndex joint;
  std::vector<LinkIndex> links;
  std::vector<FeatureIndex> features;  ///< in the order of the links
};

/// A mechanism of elementary joints. A pin in a slot is replaced by a block, a link of no size with
/// a revolute and a prismatic joint, which comes after the mechanism's own links.
///
/// Two pins of one link in one straight slot are a slide with two possible orientations. The block
/// of the second one slides along the first one's block instead of the slot, in an elementary joint
/// that belongs to no joint of the mechanism: the blocks and the link with the pins are then a dyad
/// with two configurations, and the first block alone slides in the slot.
struct Linkage {
  Table<LinkIndex, std::string> links;  ///< their names
  LinkIndex ground;
  Table<ElementaryJointIndex, ElementaryJoint> joints;
  std::vector<SharedPin> pins;
  /// The joints of second pins in a slot: their displacements along it follow from the links.
  std::vector<JointIndex> second_pins = {};
};

/// The links and elementary joints of a mechanism, with a block for each pin in a slot.
[[nodiscard]] Linkage linkage_of(const Mechanism& mechanism);

using GroupIndex = Index<struct FoundGroup>;

/// A link `to` whose place relative to the link `from` is known before `from` is placed: a driver
/// moves it, or it belongs to a group that is solved relative to `from`.
struct CarriedLink {
  DriverIndex driver;          ///< does not exist where a group places it
  ElementaryJointIndex joint;  ///< with the driver
  LinkIndex from, to;
  GroupIndex group;  ///< the group solved relative to `from`; does not exist with a driver
  std::size_t groups_before = 0;  ///< how many groups are placed before: up to those of `from` and
                                  ///< of the links that the law reads
};

/// A redundant joint, which must hold where the other joints hold: two features of one kind that
/// coincide, or the line of a slot and the pin on it. The mechanism that is solved lacks its
/// constraints.
struct RedundantJoint {
  std::string name;
  FeatureIndex one, other;
  /// The line of a slot in which a pin slides instead, or the pin that holds a slide instead; does
  /// not exist if no constraint remains.
  FeatureIndex stand_in = {};
  FeatureIndex from = {};  ///< the point on the link of `other` at which such a slot begins
  bool is_turned = false;  ///< whether the joint is described from `other` to `one`
};

/// A driver whose law reads joints that groups place.
struct ReadingDriver {
  DriverIndex driver;
  /// The numbers of groups and carried links that are placed before the law can be evaluated.
  std::size_t groups_before, links_before;
  std::vector<LinkIndex> reads;  ///< the links at the joints that it reads
};

/// The links and joints of a linkage in the roles of a group's, by their indices in the group.
struct RoleAssignment {
  std::vector<LinkIndex> links;
  std::vector<ElementaryJointIndex> joints;
};

/// A group found in a mechanism.
struct FoundGroup {
  const GroupModel* model;
  std::string kind;  ///< spelled in the mechanism's order of links and joints
  /// The links in the order of the mechanism, including those that its links carry, which drivers
  /// move or earlier groups place.
  std::vector<LinkIndex> links;
  /// Assignments under which the kind is the model's representative, in a fixed order.
  std::vector<RoleAssignment> assignments;
  /// The link that holds all of the group, if the group is solved relative to it as if that link
  /// were the ground; a later group places it, and these links with it. Does not exist if the links
  /// that hold the group are placed earlier.
  LinkIndex base = {};
};

/// A slide, and the sense of its displacement: 1 if it runs from the link whose name comes first to
/// the other one, -1 if it runs back.
struct NamedSlide {
  JointIndex joint;
  double sense;
};

/// The parts that distinguish configurations, in the order of their names, whatever the order in
/// which the mechanism lists them.
struct NamedParts {
  std::vector<LinkIndex> links;  ///< that groups place
  std::vector<NamedSlide> slides;
};

/// The order in which the links of a mechanism are placed.
struct Structure {
  Linkage linkage;                   ///< with every pin of several links as joints of two
  std::vector<CarriedLink> carried;  ///< in the order in which they are placed
  Table<GroupIndex, FoundGroup> groups;
  std::vector<DriverIndex> laws;       ///< of all drivers, each after those that its law reads
  std::vector<ReadingDriver> reading;  ///< in the order in which they can be evaluated

  [[nodiscard]] std::vector<std::string> names_of(const std::vector<LinkIndex>& links) const;
  /// Links and slides in the order of their names.
  [[nodiscard]] NamedParts named_parts(const Mechanism& mechanism) const;
  /// The number of groups placed before each link.
  [[nodiscard]] Table<LinkIndex, std::size_t> groups_before() const;
  /// For each link, whether it is the ground or carried by it, whatever the laws read: no group
  /// places it.
  [[nodiscard]] Table<LinkIndex, bool> carried_by_ground() const;
  /// For each link, whether it is the ground or is placed by drivers whose laws read no link of a
  /// group: its place depends on no closure.
  [[nodiscard]] Table<LinkIndex, bool> placed_by_drivers() const;
  /// The groups that hold a group or shape its links, directly or through a carried link, each of
  /// them once.
  [[nodiscard]] std::vector<GroupIndex> holders_of(GroupIndex group) const;
  /// The groups that hold a group, and those that hold these, in order.
  [[nodiscard]] std::vector<GroupIndex> all_holders_of(GroupIndex group) const;
  /// For each link, whether it is placed once all groups that hold a group are: it belongs to
  /// these, or drivers place it relative to them by laws that read only placed links.
  [[nodiscard]] Table<LinkIndex, bool> placed_before(GroupIndex group) const;
  /// Whether laws of drivers change the shapes of groups' links, or read other joints.
  [[nodiscard]] bool moves_by_laws(const Mechanism& mechanism) const;
  /// The indices of the carried links that the base of a group carries when the group is solved;
  /// empty if the group has no base.
  [[nodiscard]] std::vector<std::size_t> carried_by_base(GroupIndex group) const;
  /// Whether groups are solved relative to links that move.
  [[nodiscard]] bool has_relative_groups() const;
  /// The entry of a link among the carried links; null if nothing carries it.
  [[nodiscard]] const CarriedLink* carried_link(LinkIndex link) const;
};

/// The joints that the law of a driver names, and those that the laws of these name.
[[nodiscard]] std::vector<JointIndex> joints_in_laws(const Mechanism& mechanism,
                                                     DriverIndex driver);

/// Throws MechanismError for a mechanism that is over- or under-constrained, without a ground, or
/// with an unsupported group.
[[nodiscard]] Structure structure_of(const Mechanism& mechanism);

}  // namespace assur::mechanism
