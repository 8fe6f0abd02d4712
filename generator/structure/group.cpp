#include "structure/group.hpp"

#include <algorithm>
#include <cctype>
#include <deque>
#include <numeric>
#include <set>
#include <utility>

#include "error.hpp"

namespace assur::generator::structure {

namespace {

/// The link on the other side of a joint.
int across(const Joint& joint, int link) {
  return joint.first == link ? joint.second : joint.first;
}

}  // namespace

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
    std::vector<int> holders;
    for (int link = 0; link < link_count(); ++link) {
      if (links_[static_cast<std::size_t>(link)].find(letter) != std::string::npos) {
        holders.push_back(link);
      }
    }
    if (holders.empty() || holders.size() > 2) {
      throw GeneratorError("structure", name_,
                           std::string("joint ") + letter + " must be in one link or in two");
    }
    if (holders.size() == 1) {
      joints_.push_back({letter, base_link, holders[0]});
    } else {
      joints_.push_back({letter, holders[0], holders[1]});
    }
  }
}

int Group::joint_index(char name) const {
  const auto found = std::find_if(joints_.begin(), joints_.end(),
                                  [name](const Joint& joint) { return joint.name == name; });
  if (found == joints_.end()) {
    throw GeneratorError("structure", name_, std::string("no joint ") + name);
  }
  return static_cast<int>(found - joints_.begin());
}

std::vector<int> Group::joints_of(int link) const {
  std::vector<int> result;
  for (const char letter : links_[static_cast<std::size_t>(link)]) {
    result.push_back(joint_index(letter));
  }
  return result;
}

std::vector<std::vector<int>> Group::automorphisms() const {
  // A link is known by the set of its joints, and an external joint by being in one link only, so
  // the link sets alone decide whether a permutation of the joints keeps the graph.
  std::set<std::set<int>> link_sets;
  for (int link = 0; link < link_count(); ++link) {
    const std::vector<int> joints = joints_of(link);
    link_sets.emplace(joints.begin(), joints.end());
  }
  std::vector<std::vector<int>> result;
  std::vector<int> image(joints_.size());
  std::iota(image.begin(), image.end(), 0);
  do {
    const bool keeps_links =
        std::all_of(link_sets.begin(), link_sets.end(), [&](const std::set<int>& link) {
          std::set<int> moved;
          for (const int joint : link) {
            moved.insert(image[static_cast<std::size_t>(joint)]);
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
  tree.entry.assign(group.links().size(), -1);
  std::vector<bool> used(group.joints().size(), false);
  std::deque<int> queue{base_link};
  while (!queue.empty()) {
    const int link = queue.front();
    queue.pop_front();
    for (int index = 0; index < group.joint_count(); ++index) {
      const Joint& joint = group.joints()[static_cast<std::size_t>(index)];
      if (joint.first != link && joint.second != link) {
        continue;
      }
      const int next = across(joint, link);
      if (next == base_link || tree.entry[static_cast<std::size_t>(next)] != -1) {
        continue;
      }
      tree.entry[static_cast<std::size_t>(next)] = index;
      used[static_cast<std::size_t>(index)] = true;
      tree.visit_order.push_back(next);
      queue.push_back(next);
    }
  }
  for (int index = 0; index < group.joint_count(); ++index) {
    if (!used[static_cast<std::size_t>(index)]) {
      tree.chords.push_back(index);
    }
  }
  return tree;
}

std::vector<int> SpanningTree::path_to(const Group& group, int link) const {
  std::vector<int> path;
  for (int at = link; at != base_link;) {
    const int joint = entry[static_cast<std::size_t>(at)];
    path.push_back(joint);
    at = across(group.joints()[static_cast<std::size_t>(joint)], at);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

std::string loop_name(const Group& group, const SpanningTree& tree, int chord) {
  const Joint& joint = group.joints()[static_cast<std::size_t>(chord)];
  std::vector<int> loop = joint.external() ? std::vector<int>{} : tree.path_to(group, joint.first);
  std::vector<int> back = tree.path_to(group, joint.second);
  // What both sides share is walked to and fro and drops out of the loop.
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
  for (const int index : loop) {
    name += group.joints()[static_cast<std::size_t>(index)].name;
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
