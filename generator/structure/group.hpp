// Turns the links of an Assur group, spelled by their joints, into a graph of links and joints.
#pragma once

#include <string>
#include <vector>

namespace assur::generator::structure {

/// The frame, or whatever moving links the external joints attach to.
inline constexpr int base_link = -1;

/// A joint of a group. Its slide is measured from `first` to `second`.
struct Joint {
  char name;
  int first;   ///< index of a link, or `base_link` for an external joint
  int second;  ///< index of a link, always greater than `first`

  [[nodiscard]] bool external() const { return first == base_link; }
};

/// An Assur group as a graph. A link is the word of its joints, so that a joint in two words is
/// internal and a joint in one word is external, i.e. attached to the base.
class Group {
 public:
  /// `spelling` gives the order in which a kind spells its joints, with separators: `BCG-EDF`.
  Group(std::string name, int assur_class, std::vector<std::string> links, std::string spelling);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] int assur_class() const { return assur_class_; }
  [[nodiscard]] const std::vector<std::string>& links() const { return links_; }
  [[nodiscard]] const std::string& spelling() const { return spelling_; }
  /// The joints in the order of the spelling.
  [[nodiscard]] const std::vector<Joint>& joints() const { return joints_; }
  [[nodiscard]] int link_count() const { return static_cast<int>(links_.size()); }
  [[nodiscard]] int joint_count() const { return static_cast<int>(joints_.size()); }
  /// Position of a joint in the spelling; the name must exist.
  [[nodiscard]] int joint_index(char name) const;
  /// Joints of one link in the order of its word.
  [[nodiscard]] std::vector<int> joints_of(int link) const;

  /// Every permutation of the joints that maps links onto links and keeps the base, the identity
  /// first: `result[k][j]` is the image of joint j.
  [[nodiscard]] std::vector<std::vector<int>> automorphisms() const;

 private:
  std::string name_;
  int assur_class_;
  std::vector<std::string> links_;
  std::string spelling_;
  std::vector<Joint> joints_;
};

/// The spanning tree that a breadth-first walk from the base finds, and the joints left over: each
/// of those closes one independent loop.
struct SpanningTree {
  std::vector<int> entry;        ///< for each link the joint by which the walk enters it
  std::vector<int> visit_order;  ///< links in the order of the walk
  std::vector<int> chords;       ///< joints that close a loop

  /// Joints from the base to `link` along the tree.
  [[nodiscard]] std::vector<int> path_to(const Group& group, int link) const;
};

[[nodiscard]] SpanningTree spanning_tree(const Group& group);

/// The loop that a chord closes, as the word of its joints: `BCDEB`.
[[nodiscard]] std::string loop_name(const Group& group, const SpanningTree& tree, int chord);

/// The groups that the generator knows, as rows of data.
[[nodiscard]] const std::vector<Group>& known_groups();
[[nodiscard]] const Group& group_named(const std::string& name);

}  // namespace assur::generator::structure
