#include "groups/loops.hpp"

#include <algorithm>
#include <utility>

namespace assur::mechanism::groups {

namespace {

/// The joints over which a walk from some link, or from the base, reaches each link first.
template <typename Leads>
void walk(const Loops& loops, int from, const Leads& leads, std::vector<bool>& is_reached,
          std::vector<Reached>& result) {
  std::vector<int> waiting{from};
  for (std::size_t next = 0; next < waiting.size(); ++next) {
    const int link = waiting[next];
    for (std::size_t index = 0; index < loops.joints.size(); ++index) {
      const ModelJoint& at = loops.joints[index];
      if ((at.first != link && at.second != link) || !leads(at)) {
        continue;
      }
      const int joint = static_cast<int>(index);
      const int other = loops.other(joint, link);
      if (other != base_link && !is_reached[static_cast<std::size_t>(other)]) {
        is_reached[static_cast<std::size_t>(other)] = true;
        result.push_back({other, joint});
        waiting.push_back(other);
      }
    }
  }
}

}  // namespace

std::vector<int> slide_angles_of(const Loops& loops) {
  std::vector<int> result(static_cast<std::size_t>(loops.slide_count));
  for (std::size_t joint = 0; joint < loops.joints.size(); ++joint) {
    if (const int slide = loops.slide[joint]; slide >= 0) {
      result[static_cast<std::size_t>(slide)] = loops.angle_of(loops.joints[joint].second);
    }
  }
  return result;
}

std::optional<Loops> loops_of(int link_count, std::vector<ModelJoint> joints) {
  const auto links = static_cast<std::size_t>(link_count);
  Loops loops{link_count, std::move(joints), std::vector<int>(links, 0), 0, {}, 0, {}, {}, {}, {}};
  for (const ModelJoint& joint : loops.joints) {
    loops.slide.push_back(joint.prismatic ? loops.slide_count++ : -1);
  }
  const auto slides = [](const ModelJoint& joint) { return joint.prismatic; };
  std::vector<bool> is_turned(links, false);
  walk(loops, base_link, slides, is_turned, loops.turned);
  for (int link = 0; link < link_count; ++link) {
    if (!is_turned[static_cast<std::size_t>(link)]) {
      is_turned[static_cast<std::size_t>(link)] = true;
      loops.free_turned.push_back(link);
      const std::size_t before = loops.turned.size();
      walk(loops, link, slides, is_turned, loops.turned);
      ++loops.angle_count;
      loops.angle[static_cast<std::size_t>(link)] = loops.angle_count;
      for (std::size_t tied = before; tied < loops.turned.size(); ++tied) {
        loops.angle[static_cast<std::size_t>(loops.turned[tied].link)] = loops.angle_count;
      }
    }
  }
  if (std::ssize(loops.turned) != loops.slide_count) {
    return std::nullopt;
  }
  std::vector<bool> is_placed(links, false);
  walk(
      loops, base_link, [](const ModelJoint&) { return true; }, is_placed, loops.placed);
  for (std::size_t joint = 0; joint < loops.joints.size(); ++joint) {
    const bool leads = std::ranges::any_of(
        loops.placed, [&](const Reached& one) { return one.joint == static_cast<int>(joint); });
    if (!leads) {
      loops.closing.push_back(static_cast<int>(joint));
    }
  }
  return loops;
}

}  // namespace assur::mechanism::groups
