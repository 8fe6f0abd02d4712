#include "grouping.hpp"

#include <algorithm>
#include <tuple>

namespace assur::mechanism::plan {

namespace {

template <typename Item>
bool contains(const std::vector<Item>& items, const Item& item) {
  return std::find(items.begin(), items.end(), item) != items.end();
}

/// The linkage's joint for each joint of the group, with `links` in the roles of the group's links
/// in this order; empty if the graphs differ. External joints may lead to any placed link.
std::vector<ElementaryJointIndex> matched_joints(const GroupStructure& group,
                                                 const Linkage& linkage,
                                                 const std::vector<LinkIndex>& links,
                                                 const std::vector<ElementaryJointIndex>& joints) {
  std::vector<ElementaryJointIndex> result;
  const auto played = [&](int link) { return links[static_cast<std::size_t>(link)]; };
  for (const ModelJoint& wanted : group.joints) {
    const LinkIndex second = played(wanted.second);
    const auto fits = [&](ElementaryJointIndex index) {
      const ElementaryJoint& joint = linkage.joints[index];
      if (contains(result, index)) {
        return false;
      }
      return wanted.first == base_link
                 ? joint.touches(second) && !contains(links, joint.other(second))
                 : joint.joins(played(wanted.first), second);
    };
    const auto found = std::find_if(joints.begin(), joints.end(), fits);
    if (found == joints.end()) {
      return {};
    }
    result.push_back(*found);
  }
  return result;
}

std::vector<bool> prismatic_joints(const Linkage& linkage,
                                   const std::vector<ElementaryJointIndex>& joints) {
  std::vector<bool> prismatic;
  for (const ElementaryJointIndex joint : joints) {
    prismatic.push_back(linkage.joints[joint].prismatic);
  }
  return prismatic;
}

}  // namespace

std::optional<FoundGroup> find_group(const Linkage& linkage, const std::vector<LinkIndex>& moving,
                                     const std::vector<ElementaryJointIndex>& joints) {
  for (const GroupModels& group : known_groups()) {
    if (group.structure.link_count() != moving.size() ||
        group.structure.joints.size() != joints.size()) {
      continue;
    }
    std::vector<RoleAssignment> assignments;
    std::vector<LinkIndex> links = moving;
    std::sort(links.begin(), links.end());
    do {
      auto matched = matched_joints(group.structure, linkage, links, joints);
      if (!matched.empty()) {
        assignments.push_back({links, std::move(matched)});
      }
    } while (std::next_permutation(links.begin(), links.end()));
    if (assignments.empty()) {
      continue;
    }
    const auto spelled_first = std::min_element(
        assignments.begin(), assignments.end(),
        [](const RoleAssignment& left, const RoleAssignment& right) {
          return std::tie(left.links[0], left.joints) < std::tie(right.links[0], right.joints);
        });
    const GroupModels::Served served =
        group.serving(prismatic_joints(linkage, spelled_first->joints));
    FoundGroup found{served.model, served.kind, moving, {}};
    for (RoleAssignment& assignment : assignments) {
      if (prismatic_joints(linkage, assignment.joints) == found.model->prismatic) {
        found.assignments.push_back(std::move(assignment));
      }
    }
    return found;
  }
  return std::nullopt;
}

std::optional<FoundGroup> derived_group(const Linkage& linkage,
                                        const std::vector<LinkIndex>& moving,
                                        const std::vector<ElementaryJointIndex>& joints,
                                        std::string& obstacle) {
  RoleAssignment roles{moving, joints};
  std::ranges::sort(roles.links, {}, [&](LinkIndex link) { return linkage.links[link]; });
  const auto place = [&](LinkIndex link) {
    const auto found = std::ranges::find(roles.links, link);
    return found == roles.links.end() ? base_link : static_cast<int>(found - roles.links.begin());
  };
  const auto ends = [&](ElementaryJointIndex joint) {
    const ElementaryJoint& at = linkage.joints[joint];
    return std::minmax({place(at.first), place(at.second)});
  };
  std::ranges::sort(roles.joints, {}, [&](ElementaryJointIndex joint) {
    const ElementaryJoint& at = linkage.joints[joint];
    return std::make_tuple(at.name, ends(joint), at.prismatic);
  });
  std::vector<ModelJoint> graph;
  for (const ElementaryJointIndex joint : roles.joints) {
    const auto [first, second] = ends(joint);
    graph.push_back({'\0', first, second, linkage.joints[joint].prismatic});
  }
  if (moving.size() > most_links_of_group) {
    obstacle = "groups of at most " + std::to_string(most_links_of_group) + " links are solved";
    return std::nullopt;
  }
  const GroupModel* model = derived_model(static_cast<int>(moving.size()), graph, obstacle);
  if (model == nullptr) {
    return std::nullopt;
  }
  return FoundGroup{model, model->kinds.front(), moving, {std::move(roles)}};
}

int assur_class_of(const Linkage& linkage, const std::vector<LinkIndex>& moving,
                   const std::vector<ElementaryJointIndex>& joints) {
  const auto place = [&](LinkIndex link) {
    const auto found = std::find(moving.begin(), moving.end(), link);
    return found == moving.end() ? base_link : static_cast<int>(found - moving.begin());
  };
  std::vector<JointPair> pairs;
  for (const ElementaryJointIndex joint : joints) {
    pairs.push_back({place(linkage.joints[joint].first), place(linkage.joints[joint].second)});
  }
  return assur_class_of(static_cast<int>(moving.size()), pairs);
}

}  // namespace assur::mechanism::plan
