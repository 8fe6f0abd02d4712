#include "scene/grouping.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <tuple>

namespace assur::generator {

namespace {

/// Joints of the mechanism for each joint of the group when `links` play its links; empty if the
/// graphs differ. External joints go to any placed link.
std::vector<int> matched_joints(const Group& group, const Mechanism& mechanism,
                                const std::vector<int>& links, const std::vector<int>& joints) {
  const std::set<int> moving(links.begin(), links.end());
  std::vector<int> result;
  std::set<int> used;
  for (const Joint& wanted : group.joints()) {
    const int second = links[static_cast<std::size_t>(wanted.second)];
    const auto fits = [&](int index) {
      const MechanismJoint& joint = mechanism.joints[static_cast<std::size_t>(index)];
      if (used.contains(index)) {
        return false;
      }
      if (wanted.external()) {
        const int other = joint.first == second ? joint.second : joint.first;
        return (joint.first == second || joint.second == second) && !moving.contains(other);
      }
      return joint.joins(links[static_cast<std::size_t>(wanted.first)], second);
    };
    const auto found = std::find_if(joints.begin(), joints.end(), fits);
    if (found == joints.end()) {
      return {};
    }
    used.insert(*found);
    result.push_back(*found);
  }
  return result;
}

Kind kind_of(const Mechanism& mechanism, const std::vector<int>& joints) {
  Kind kind;
  for (const int joint : joints) {
    kind.push_back(mechanism.joints[static_cast<std::size_t>(joint)].prismatic
                       ? JointType::prismatic
                       : JointType::revolute);
  }
  return kind;
}

}  // namespace

std::optional<FoundGroup> find_group(const Mechanism& mechanism, const std::vector<int>& moving,
                                     const std::vector<int>& joints) {
  for (const Group& group : known_groups()) {
    if (group.links().size() != moving.size() || group.joints().size() != joints.size()) {
      continue;
    }
    std::vector<RoleAssignment> assignments;
    std::vector<int> links = moving;
    std::sort(links.begin(), links.end());
    do {
      std::vector<int> matched = matched_joints(group, mechanism, links, joints);
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
    const Kind kind = kind_of(mechanism, spelled_first->joints);
    FoundGroup found{&model_of(group, kind), kind, {}};
    for (RoleAssignment& assignment : assignments) {
      if (kind_of(mechanism, assignment.joints) == found.model->representative) {
        found.assignments.push_back(std::move(assignment));
      }
    }
    return found;
  }
  return std::nullopt;
}

int assur_class_of(const Mechanism& mechanism, const std::vector<int>& moving,
                   const std::vector<int>& joints) {
  int largest = 2;
  for (const int link : moving) {
    const auto count = std::count_if(joints.begin(), joints.end(), [&](int index) {
      const MechanismJoint& joint = mechanism.joints[static_cast<std::size_t>(index)];
      return joint.first == link || joint.second == link;
    });
    // A link whose joints all lead into the group closes a contour; with one that leads out, the
    // other two lie on a contour of several links.
    const bool inner = std::all_of(joints.begin(), joints.end(), [&](int index) {
      const MechanismJoint& joint = mechanism.joints[static_cast<std::size_t>(index)];
      const bool own = joint.first == link || joint.second == link;
      const int other = joint.first == link ? joint.second : joint.first;
      return !own || std::find(moving.begin(), moving.end(), other) != moving.end();
    });
    largest = inner ? std::max(largest, static_cast<int>(count)) : largest;
  }
  // The longest walk over different links that comes back to where it began.
  std::vector<int> walk;
  const std::function<void(int)> extend = [&](int link) {
    walk.push_back(link);
    for (const int index : joints) {
      const MechanismJoint& joint = mechanism.joints[static_cast<std::size_t>(index)];
      if (joint.first != link && joint.second != link) {
        continue;
      }
      const int next = joint.first == link ? joint.second : joint.first;
      if (next == walk.front() && walk.size() > 2) {
        largest = std::max(largest, static_cast<int>(walk.size()));
      } else if (std::find(moving.begin(), moving.end(), next) != moving.end() &&
                 std::find(walk.begin(), walk.end(), next) == walk.end()) {
        extend(next);
      }
    }
    walk.pop_back();
  };
  for (const int link : moving) {
    extend(link);
  }
  return largest;
}

}  // namespace assur::generator
