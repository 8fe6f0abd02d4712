#include "structure/group.hpp"

#include <algorithm>
#include <cctype>
#include <deque>
#include <set>
#include <utility>

#include "error.hpp"

namespace assur::generator::structure {

Group::Group(std::string name, int assur_class, std::vector<std::string> links,
             std::string spelling)
    : name_(std::move(name)),
      assur_class_(assur_class),
      links_(std::move(links)),
      spelling_(std::move(spelling)) {
  for (const char letter : spelling_) {
    if (std::isupper(static_cast<unsigned char>(letter)) == 0) {
      continue;
    }
    std::vector<LinkIndex> holders;
    for (const LinkIndex link : links_.keys()) {
      if (links_[link].find(letter) != std::string::npos) {
        holders.push_back(link);
      }
    }
    if (holders.empty() || holders.size() > 2) {
      throw GeneratorError("structure", name_,
                           std::string("joint ") + letter + " must be in one link or in two");
    }
    if (holders.size() == 1) {
      joints_.add({letter, base_link, holders[0]});
    } else {
      joints_.add({letter, holders[0], holders[1]});
    }
  }
}

std::vector<JointIndex> Group::joints_of(LinkIndex link) const {
  std::vector<JointIndex> result;
  for (const char letter : links_[link]) {
    const JointIndex joint = index_of(joints_, letter);
    if (!joint.exists()) {
      throw GeneratorError("structure", name_, std::string("no joint ") + letter);
    }
    result.push_back(joint);
  }
  return result;
}

std::vector<JointTable<JointIndex>> Group::automorphisms() const {
  // A link is known by the set of its joints, and an external joint by being in one link only, so
  // the link sets alone decide whether a permutation of the joints keeps the graph.
  std::set<std::set<JointIndex>> link_sets;
  for (const LinkIndex link : links_.keys()) {
    const std::vector<JointIndex> joints = joints_of(link);
    link_sets.emplace(joints.begin(), joints.end());
  }
  std::vector<JointTable<JointIndex>> result;
  JointTable<JointIndex> image;
  for (const JointIndex joint : joints_.keys()) {
    image.add(joint);
  }
  do {
    const bool keeps_links =
        std::all_of(link_sets.begin(), link_sets.end(), [&](const std::set<JointIndex>& link) {
          std::set<JointIndex> moved;
          for (const JointIndex joint : link) {
            moved.insert(image[joint]);
          }
          return link_sets.count(moved) == 1;
        });
    if (keeps_links) {
      result.push_back(image);
    }
  } while (std::next_permutation(image.begin(), image.end()));
  return result;
}

SpanningTree spanning_tree(const Group& group) {
  SpanningTree tree;
  tree.entry.resize(group.links().size());
  JointTable<bool> used(group.joints().size(), false);
  std::deque<LinkIndex> queue{base_link};
  while (!queue.empty()) {
    const LinkIndex link = queue.front();
    queue.pop_front();
    for (const JointIndex index : group.joints().keys()) {
      const Joint& joint = group.joints()[index];
      if (joint.first != link && joint.second != link) {
        continue;
      }
      const LinkIndex next = joint.other(link);
      if (next == base_link || tree.entry[next].exists()) {
        continue;
      }
      tree.entry[next] = index;
      used[index] = true;
      tree.visit_order.push_back(next);
      queue.push_back(next);
    }
  }
  for (const JointIndex index : used.keys()) {
    if (!used[index]) {
      tree.chords.push_back(index);
    }
  }
  return tree;
}

std::vector<JointIndex> SpanningTree::path_to(const Group& group, LinkIndex link) const {
  std::vector<JointIndex> path;
  for (LinkIndex at = link; at != base_link;) {
    const JointIndex joint = entry[at];
    path.push_back(joint);
    at = group.joints()[joint].other(at);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

std::string loop_name(const Group& group, const SpanningTree& tree, JointIndex chord) {
  const Joint& joint = group.joints()[chord];
  std::vector<JointIndex> loop =
      joint.external() ? std::vector<JointIndex>{} : tree.path_to(group, joint.first);
  std::vector<JointIndex> back = tree.path_to(group, joint.second);
  // Joints shared by both paths are passed there and back, so they drop out of the loop.
  while (!loop.empty() && !back.empty() && loop.front() == back.front()) {
    loop.erase(loop.begin());
    back.erase(back.begin());
  }
  loop.push_back(chord);
  loop.insert(loop.end(), back.rbegin(), back.rend());
  if (loop.back() < loop.front()) {
    std::reverse(loop.begin(), loop.end());
  }
  loop.push_back(loop.front());
  std::string name;
  for (const JointIndex index : loop) {
    name += group.joints()[index].name;
  }
  return name;
}

const std::vector<Group>& known_groups() {
  static const std::vector<Group> groups = {
      {"dyad", 2, {"BC", "CD"}, "BCD"},
      {"triad", 3, {"CEG", "BC", "DE", "FG"}, "BC-DE-FG"},
      {"tetrad", 4, {"BCG", "EDF", "CD", "GF"}, "BCG-EDF"},
  };
  return groups;
}

const Group& group_named(const std::string& name) {
  for (const Group& group : known_groups()) {
    if (group.name() == name) {
      return group;
    }
  }
  throw GeneratorError("structure", name, "no such group");
}

}  // namespace assur::generator::structure
