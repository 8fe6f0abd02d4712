#include "closing_gaps.hpp"

#include <algorithm>
#include <assur/text/names.hpp>
#include <assur/text/numbers.hpp>
#include <numbers>

#include "group_reasons.hpp"
#include "longest_on_links.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism::solve {

ClosingGaps::ClosingGaps(const Placement& placement)
    : placement_(placement),
      structure_(placement.structure()),
      failures_(structure_.groups.size()) {}

void ClosingGaps::begin(bool measures) {
  measures_ = measures;
  for (Failures& failures : failures_) {
    failures = Failures();
  }
}

void ClosingGaps::meet(GroupIndex group) {
  if (measures_) {
    failures_[group].met.insert(choices_of(structure_.all_holders_of(group)));
  }
}

void ClosingGaps::fail(GroupIndex group) {
  double gap = 0;
  if (!measures_ || placement_.solver(group).gap(gap) != Status::ok) {
    return;
  }
  Failures& failures = failures_[group];
  failures.failed.insert(choices_of(structure_.all_holders_of(group)));
  if (gap < failures.least_gap) {
    failures.least_gap = gap;
    failures.holders = stance_of_holders(group);
  }
}

bool ClosingGaps::is_in_doubt(GroupIndex group) const {
  constexpr double of_size = 1e-6;
  double gap = 0;
  const GroupSolver& solver = placement_.solver(group);
  return solver.is_held_loosely() && solver.gap(gap) == Status::ok &&
         gap < of_size * longest_on_links(placement_.values());
}

std::vector<std::size_t> ClosingGaps::choices_of(const std::vector<GroupIndex>& groups) const {
  std::vector<std::size_t> choices;
  for (const GroupIndex group : groups) {
    choices.push_back(placement_.choice(group));
  }
  return choices;
}

std::vector<std::string> ClosingGaps::stance_of_holders(GroupIndex group) const {
  std::vector<std::string> holders;
  const Table<LinkIndex, bool> stands = structure_.placed_by_drivers();
  for (const LinkIndex link : placement_.plan().mechanism.links().keys()) {
    const bool holds =
        link != structure_.groups[group].base &&
        std::ranges::any_of(placement_.values().numbers_of(group).held,
                            [link](const values::HeldJoint& joint) { return joint.base == link; });
    if (!holds || stands[link]) {
      continue;
    }
    const CarriedLink* carried = structure_.carried_link(link);
    const bool slides = carried != nullptr && carried->joint.exists() &&
                        structure_.linkage.joints[carried->joint].prismatic;
    const double degrees =
        angle_of(placement_.placed().links[link].pose.direction) * 180 / std::numbers::pi;
    holders.push_back(
        slides ? structure_.linkage.links[link] + " moved by " +
                     text::short_number(
                         placement_.values().motion(carried->driver).position.value(), 3)
               : structure_.linkage.links[link] + " at " + text::short_number(degrees, 3) + " deg");
  }
  return holders;
}

std::string ClosingGaps::reason() const {
  const auto least = std::ranges::min_element(failures_, {}, &Failures::least_gap);
  if (least == failures_.end() || least->failed.empty()) {
    return "";
  }
  const GroupIndex group(static_cast<std::size_t>(least - failures_.begin()));
  const FoundGroup& found = structure_.groups[group];
  std::string reason =
      "group " + std::to_string(group.place() + 1) + " (" + found.model->group->name + " " +
      found.kind + ": " + text::listed(structure_.names_of(found.links)) +
      (found.base.exists() ? ", relative to " + structure_.linkage.links[found.base] : "") +
      "): the joints " + text::listed(joint_names(placement_.values(), group, false)) +
      " fail to close by " + text::short_number(least->least_gap, 3) + " at least";
  std::vector<std::string> holders;
  for (const GroupIndex holder : structure_.all_holders_of(group)) {
    holders.push_back(std::to_string(holder.place() + 1));
  }
  if (!holders.empty()) {
    reason +=
        ", in " + std::to_string(least->failed.size()) + " of " +
        std::to_string(least->met.size()) + " configurations of " +
        (holders.size() == 1 ? "group " : "the groups ") + text::listed(holders) +
        (least->holders.empty() ? ""
                                : " (the gap is least with " + text::listed(least->holders) + ")");
  }
  if (const std::string& flaw = placement_.values().group(group).flaw; !flaw.empty()) {
    reason += "; " + flaw;
  }
  return reason;
}

}  // namespace assur::mechanism::solve
