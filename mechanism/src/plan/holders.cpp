// Groups that hold a group, and the links that these place.
#include <algorithm>
#include <assur/mechanism/structure.hpp>
#include <set>

namespace assur::mechanism::plan {
namespace {

/// For each link, whether it is placed once some groups are.
Table<LinkIndex, bool> placed_with(const Structure& structure,
                                   const std::vector<GroupIndex>& groups) {
  Table<LinkIndex, bool> placed(structure.linkage.links.size(), false);
  placed[structure.linkage.ground] = true;
  for (const GroupIndex group : groups) {
    if (structure.groups[group].base.exists()) {
      continue;  // It places its links relative to its base.
    }
    for (const LinkIndex link : structure.groups[group].links) {
      placed[link] = true;
    }
  }
  for (const CarriedLink& link : structure.carried) {
    const auto waits = [&](const ReadingDriver& one) {
      return one.driver == link.driver &&
             !std::ranges::all_of(one.reads, [&](LinkIndex read) { return placed[read]; });
    };
    const bool has_shape =
        !link.group.exists() || std::ranges::find(groups, link.group) != groups.end();
    placed[link.to] =
        placed[link.from] && has_shape && std::ranges::none_of(structure.reading, waits);
  }
  return placed;
}

}  // namespace
}  // namespace assur::mechanism::plan

namespace assur::mechanism {

std::vector<GroupIndex> Structure::holders_of(GroupIndex group) const {
  std::vector<GroupIndex> holders;
  const auto add_group_of = [&](LinkIndex link) {
    for (std::size_t place = 0; place < group.place(); ++place) {
      const GroupIndex before(place);
      const std::vector<LinkIndex>& links = groups[before].links;
      if (std::ranges::find(links, link) != links.end() &&
          std::ranges::find(holders, before) == holders.end()) {
        holders.push_back(before);
      }
    }
  };
  const auto add = [&](LinkIndex link) {
    add_group_of(link);
    for (const CarriedLink* step = carried_link(link); step != nullptr;
         step = carried_link(step->from)) {
      for (const ReadingDriver& one : reading) {
        if (one.driver == step->driver) {
          std::ranges::for_each(one.reads, add_group_of);
        }
      }
    }
  };
  for (const ElementaryJointIndex joint : groups[group].assignments.front().joints) {
    const ElementaryJoint& at = linkage.joints[joint];
    for (const LinkIndex link : {at.first, at.second, at.holder_first, at.holder_second}) {
      add(link);
    }
  }
  std::ranges::sort(holders);
  return holders;
}

std::vector<GroupIndex> Structure::all_holders_of(GroupIndex group) const {
  std::set<GroupIndex> all;
  std::vector<GroupIndex> waiting{group};
  while (!waiting.empty()) {
    const GroupIndex held = waiting.back();
    waiting.pop_back();
    for (const GroupIndex holder : holders_of(held)) {
      if (all.insert(holder).second) {
        waiting.push_back(holder);
      }
    }
  }
  return {all.begin(), all.end()};
}

Table<LinkIndex, bool> Structure::placed_by_drivers() const { return plan::placed_with(*this, {}); }

Table<LinkIndex, bool> Structure::placed_before(GroupIndex group) const {
  return plan::placed_with(*this, all_holders_of(group));
}

}  // namespace assur::mechanism
