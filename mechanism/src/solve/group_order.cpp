#include "group_order.hpp"

#include <algorithm>
#include <assur/support/configuration_order.hpp>

#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

namespace {

/// The parts of a mechanism that a group places, in the same order.
NamedParts parts_of(const Structure& structure, const FoundGroup& group, const NamedParts& all) {
  NamedParts own;
  std::ranges::copy_if(all.links, std::back_inserter(own.links), [&](LinkIndex link) {
    return std::ranges::find(group.links, link) != group.links.end();
  });
  std::ranges::copy_if(all.slides, std::back_inserter(own.slides), [&](const NamedSlide& slide) {
    const auto& joints = group.assignments.front().joints;
    return std::ranges::any_of(joints, [&](ElementaryJointIndex joint) {
      return structure.linkage.joints[joint].prismatic &&
             structure.linkage.joints[joint].joint == slide.joint;
    });
  });
  return own;
}

}  // namespace

GroupOrder::GroupOrder(Placement& placement)
    : placement_(placement), keys_(models::most_configurations) {
  const Structure& structure = placement.structure();
  for (const FoundGroup& group : structure.groups) {
    parts_.add(parts_of(structure, group, placement.plan().named_parts));
  }
}

void GroupOrder::sort(GroupIndex group, std::size_t count, Visits& visits) {
  const NamedParts& parts = parts_[group];
  for (std::size_t place = 0; place < count; ++place) {
    placement_.place(group, visits[place]);
    set_order_key(parts, placement_.placed().links, placement_.placed().slides, keys_[place]);
  }
  support::put_in_order(
      keys_, static_cast<int>(count), support::turning_key_size(parts.links.size()),
      [&](std::size_t one, std::size_t other) { std::swap(visits[one], visits[other]); });
}

}  // namespace assur::mechanism::solve
