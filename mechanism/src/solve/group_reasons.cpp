#include "group_reasons.hpp"

#include <algorithm>
#include <assur/text/names.hpp>

#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

std::vector<std::string> joint_names(const Values& values, GroupIndex group, bool slides_only) {
  const RoleAssignment& roles = *values.group(group).roles;
  std::vector<std::string> names;
  for (const ElementaryJointIndex joint : roles.joints) {
    const ElementaryJoint& at = values.shared_plan()->structure.linkage.joints[joint];
    if (at.prismatic || !slides_only) {
      names.push_back(at.name);
    }
  }
  std::ranges::sort(names);  // roles follow the listing, names do not
  // A pin of several links, or a pin in a slot, has several elementary joints and is named once.
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

namespace {

/// The reason why no group of this model has isolated configurations.
std::string reason_of_model(const Values& values, GroupIndex group, const std::string& what) {
  return "prismatic joints close a loop and over-determine its angles (among the joints " +
         text::listed(joint_names(values, group, true)) + "); " + what;
}

}  // namespace

std::string reason_of_freedom(const Values& values, GroupIndex group) {
  if (!values.plan().structure.groups[group].model->rigid) {
    return reason_of_model(values, group, "these angles are compatible here, and the group moves");
  }
  return "the closure of the joints " + text::listed(joint_names(values, group, false)) +
         " leaves an angle or a displacement free, so there are infinitely many positions";
}

std::string reason_of_doubt(const Values& values, GroupIndex group) {
  return "the closure of the joints " + text::listed(joint_names(values, group, false)) +
         " depends on the last digit: rounding cannot separate two configurations of the links "
         "that hold their group";
}

std::string reason_of_incompleteness(const Values& values, GroupIndex group, int found) {
  const FoundGroup& of = values.plan().structure.groups[group];
  return "group " + std::to_string(group.place() + 1) + " (" + of.model->group->name + ": " +
         text::listed(values.plan().structure.names_of(of.links)) + ") has " +
         std::to_string(of.model->max_configurations) +
         " configurations in complex numbers in general position, of which " +
         std::to_string(found) +
         " were found isolated here: in this special position others may be missing";
}

std::string reason_of_conflict(const Values& values, GroupIndex group) {
  return reason_of_model(values, group,
                         "these angles are not compatible here, and the group cannot be assembled");
}

}  // namespace assur::mechanism::solve
