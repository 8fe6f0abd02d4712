// Assur groups as graphs of links and joints.
#pragma once

#include <assur/text/index.hpp>
#include <string>
#include <vector>

namespace assur::generator::structure {

// NOLINTNEXTLINE(bugprone-forward-declaration-namespace): it only tells indices apart
using LinkIndex = text::Index<struct Link>;
using JointIndex = text::Index<struct Joint>;
/// An item for each link of a group.
template <typename Item>
using LinkTable = text::Table<LinkIndex, Item>;
/// An item for each joint of a group.
template <typename Item>
using JointTable = text::Table<JointIndex, Item>;

/// The frame, or the moving links that the external joints attach to; not a link of the group.
inline constexpr LinkIndex base_link{};

/// A joint of a group. Its slide is measured from `first` to `second`.
struct Joint {
  char name;
  LinkIndex first;   ///< `base_link` for an external joint
  LinkIndex second;  ///< always greater than `first`

  [[nodiscard]] bool external() const { return first == base_link; }
  /// The link on the other side.
  [[nodiscard]] LinkIndex other(LinkIndex link) const { return first == link ? second : first; }
};

/// An Assur group as a graph. A link is spelled by the word of its joints; a joint in two words is
/// internal and one in a single word external, i.e. attached to the base.
class Group {
 public:
  /// `spelling` is the order of the joints in the names of kinds, with separators: `BCG-EDF`.
  Group(std::string name, int assur_class, std::vector<std::string> links, std::string spelling);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] int assur_class() const { return assur_class_; }
  [[nodiscard]] const LinkTable<std::string>& links() const { return links_; }
  [[nodiscard]] const std::string& spelling() const { return spelling_; }
  /// The joints in the order of the spelling.
  [[nodiscard]] const JointTable<Joint>& joints() const { return joints_; }
  /// Joints of one link in the order of its word.
  [[nodiscard]] std::vector<JointIndex> joints_of(LinkIndex link) const;

  /// Every permutation of the joints that maps links onto links and keeps the base, the identity
  /// first: `result[k][j]` is the image of joint j.
  [[nodiscard]] std::vector<JointTable<JointIndex>> automorphisms() const;

 private:
  std::string name_;
  int assur_class_;
  LinkTable<std::string> links_;
  std::string spelling_;
  JointTable<Joint> joints_;
};

/// The spanning tree of a breadth-first walk from the base, and the remaining joints, each of which
/// closes one independent loop.
struct SpanningTree {
  LinkTable<JointIndex> entry;         ///< for each link the joint by which the walk enters it
  std::vector<LinkIndex> visit_order;  ///< links in the order of the walk
  std::vector<JointIndex> chords;      ///< joints that close a loop

  /// Joints from the base to `link` along the tree.
  [[nodiscard]] std::vector<JointIndex> path_to(const Group& group, LinkIndex link) const;
};

[[nodiscard]] SpanningTree spanning_tree(const Group& group);

/// The loop that a chord closes, as the word of its joints: `BCDEB`.
[[nodiscard]] std::string loop_name(const Group& group, const SpanningTree& tree, JointIndex chord);

/// The groups known to the generator.
[[nodiscard]] const std::vector<Group>& known_groups();
[[nodiscard]] const Group& group_named(const std::string& name);

}  // namespace assur::generator::structure
