#include "family_search.hpp"

#include <algorithm>
#include <assur/numeric/order.hpp>
#include <cmath>

#include "group_reasons.hpp"
#include "search_bounds.hpp"

namespace assur::mechanism::solve {

FamilySearch::FamilySearch(Placement& placement, ClosingGaps& gaps)
    : placement_(placement), gaps_(gaps), structure_(placement.structure()) {}

void FamilySearch::begin(std::vector<Family>& families, bool one) {
  families_ = &families;
  families_->clear();
  one_is_enough_ = one;
}

void FamilySearch::add(GroupIndex group, int mobility, std::string reason) {
  add(group, mobility, std::move(reason), Unplaced(structure_.linkage.links.size(), false));
}

void FamilySearch::add(GroupIndex group, int mobility, std::string reason, Unplaced unplaced) {
  if (one_is_enough_ && !families_->empty()) {
    return;
  }
  leave_out(group, unplaced);
  const PlacedLinks placed = placement_.placed();
  if (rest_assembles(group.place() + 1, unplaced)) {
    placement_.placed() = placed;
    Family family{group, mobility, std::move(reason), structure_.placed_before(group),
                  placed.links};
    if (!is_listed(family)) {
      if (families_->size() == most_families) {
        refuse_search(structure_, "more than " + std::to_string(most_families) + " families");
      }
      families_->push_back(std::move(family));
    }
    find_behind(group.place() + 1, std::move(unplaced));
  }
  placement_.placed() = placed;
}

void FamilySearch::leave_out(GroupIndex group, Unplaced& unplaced) const {
  for (const LinkIndex link : structure_.groups[group].links) {
    unplaced[link] = true;
  }
}

void FamilySearch::find_behind(std::size_t depth, Unplaced unplaced) {
  if (!placement_.move_carried_links(depth, unplaced) || depth == structure_.groups.size()) {
    return;
  }
  const GroupIndex group(depth);
  if (!placement_.can_be_solved(group, unplaced)) {
    leave_out(group, unplaced);
    find_behind(depth + 1, std::move(unplaced));
    return;
  }
  placement_.hold(group);
  const models::GroupAssemblies& found = placement_.assemble(group);
  gaps_.meet(group);
  if (found.mobility > 0) {
    add(group, found.mobility, reason_of_freedom(placement_.values(), group), unplaced);
  } else if (!found.is_compatible) {
    add(group, 0, reason_of_conflict(placement_.values(), group), unplaced);
  }
  for (std::size_t index = 0; index < found.count; ++index) {
    placement_.place(group, index);
    find_behind(depth + 1, unplaced);
  }
}

bool FamilySearch::rest_assembles(std::size_t depth, Unplaced unplaced) {
  if (!placement_.move_carried_links(depth, unplaced)) {
    return false;
  }
  if (depth == structure_.groups.size()) {
    return true;
  }
  const GroupIndex group(depth);
  if (!placement_.can_be_solved(group, unplaced)) {
    leave_out(group, unplaced);
    return rest_assembles(depth + 1, std::move(unplaced));
  }
  placement_.hold(group);
  const models::GroupAssemblies& found = placement_.assemble(group);
  gaps_.meet(group);
  for (std::size_t index = 0; index < found.count; ++index) {
    placement_.place(group, index);
    if (rest_assembles(depth + 1, unplaced)) {
      return true;
    }
  }
  const bool is_in_doubt = found.count == 0 && gaps_.is_in_doubt(group);
  if (found.mobility > 0 || !found.is_compatible || is_in_doubt) {
    leave_out(group, unplaced);
    return rest_assembles(depth + 1, std::move(unplaced));
  }
  if (found.count == 0) {
    gaps_.fail(group);
  }
  return false;
}

bool FamilySearch::is_listed(const Family& family) const {
  double longest = 0;
  for (const LinkIndex link : family.is_placed.keys()) {
    if (family.is_placed[link]) {
      const Pose<double>& pose = family.links[link].pose;
      longest = std::max({longest, std::abs(pose.x), std::abs(pose.y)});
    }
  }
  const auto are_one = [longest](const Pose<double>& one, const Pose<double>& two) {
    return !numeric::are_apart(one.x, two.x, longest) &&
           !numeric::are_apart(one.y, two.y, longest) &&
           !numeric::are_apart(one.direction.cos, two.direction.cos) &&
           !numeric::are_apart(one.direction.sin, two.direction.sin);
  };
  const auto stands_as = [&](const Family& other) {
    for (const LinkIndex link : family.is_placed.keys()) {
      if (family.is_placed[link] && !are_one(family.links[link].pose, other.links[link].pose)) {
        return false;
      }
    }
    return family.group == other.group;
  };
  return std::ranges::any_of(*families_, stands_as);
}

}  // namespace assur::mechanism::solve
