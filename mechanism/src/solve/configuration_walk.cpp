#include "configuration_walk.hpp"

#include <algorithm>
#include <assur/mechanism/plan.hpp>
#include <numeric>
#include <tuple>

#include "group_reasons.hpp"
#include "plan/plan_data.hpp"
#include "search_bounds.hpp"

namespace assur::mechanism::solve {

ConfigurationWalk::ConfigurationWalk(const Values& values)
    : placement_(values),
      placed_(placement_.placed()),
      structure_(placement_.structure()),
      values_(placement_.values()),
      gaps_(placement_),
      families_(placement_, gaps_),
      nearness_(placement_),
      group_order_(placement_),
      limits_(placement_),
      watched_(values_),
      found_(placement_, nearness_, limits_),
      is_ordered_by_groups_(most_configurations(structure_) > Plan::most_listed) {}

Answer ConfigurationWalk::walk(const SearchOptions& search, const Sought& sought,
                               Solution& result) {
  nearness_.seek_nothing();
  if (const auto* const point = std::get_if<const SoughtPoint*>(&sought)) {
    nearness_.seek(**point);
  } else if (std::holds_alternative<SoughtReference>(sought)) {
    nearness_.seek_reference();
  }
  const auto* const numbered = std::get_if<SoughtNumber>(&sought);
  const std::size_t number = numbered == nullptr ? 0 : numbered->number;
  const bool seeks_one = !std::holds_alternative<SoughtAll>(sought);
  cuts_ = search.within_limits && limits_.exist() && (seeks_one || is_ordered_by_groups_);
  begin(search, number, result);
  leaves_inconsistent_ = found_.takes_only_consistent();
  descend(0);
  found_.trim();
  if (has_left_inconsistent_ && found_.lacks_all()) {  // the gap is reported
    begin(search, number, result);
    leaves_inconsistent_ = false;
    descend(0);
    found_.trim();
  }
  Answer answer;
  answer.refusal = found_.conclude(is_ordered_by_groups_, has_cut_, gaps_);
  answer.is_unsure = found_.is_unsure();
  answer.passed = found_.passed();
  if (nearness_.is_sought() && !found_.is_empty()) {
    answer.nearest = nearness_.found();
  }
  return answer;
}

/// Resets the walk and the result, whatever state the last position left them in.
void ConfigurationWalk::begin(const SearchOptions& search, std::size_t number, Solution& result) {
  placement_.begin(search.finds_motions);
  gaps_.begin(search.measures_gap);
  nearness_.begin();
  found_.begin(search, number, cuts_, result);
  families_.begin(result.families, found_.seeks_one());
  has_cut_ = has_left_inconsistent_ = false;
}

/// Solves the groups from one on, where all before it are placed.
void ConfigurationWalk::descend(std::size_t depth) {
  if (!placement_.move_carried_links(depth)) {
    ++found_.solution().dropped;
    found_.solution().drop_reason = placement_.flaw();
    return;
  }
  if (cuts_ && !limits_.are_kept_at(depth, found_.solution().breaches)) {
    has_cut_ = true;
    return;
  }
  if (leaves_inconsistent_ && placed_.regularity == Status::ok &&
      !watched_.may_hold_at(depth, placed_.links)) {
    has_left_inconsistent_ = true;
    return;
  }
  const double before = nearness_.enter(depth);
  if (nearness_.may_count()) {
    descend_on(depth);
  }
  nearness_.leave(before);
}

void ConfigurationWalk::descend_on(std::size_t depth) {
  if (depth == structure_.groups.size()) {
    found_.list();
    return;
  }
  const GroupIndex group(depth);
  if (!placement_.solver(group).has_normal_form()) {
    families_.add(group, 0, values_.group(group).obstacle);
    return;
  }
  placement_.hold(group);
  const models::GroupAssemblies& found = placement_.assemble(group);
  gaps_.meet(group);
  if (found.count == 0 && placed_.regularity != Status::ok) {
    found_.become_unsure();
  }
  if (found.status == AssemblyStatus::not_finite) {
    throw MechanismError("links",
                         "the lengths differ by more powers of ten than double precision can hold");
  }
  if (found.status == AssemblyStatus::unsound_arithmetic) {
    throw MechanismError(
        "links",
        "the arithmetic of this build or of its process does not round as double precision "
        "does; compile without -ffast-math and its parts, and with -mfpmath=sse");
  }
  if (found.complex_count && found_.solution().incomplete.empty()) {
    found_.solution().incomplete = reason_of_incompleteness(values_, group, *found.complex_count);
  }
  if (found.mobility > 0) {
    families_.add(group, found.mobility, reason_of_freedom(values_, group));
  } else if (found.count == 0 && gaps_.is_in_doubt(group)) {
    families_.add(group, 0, reason_of_doubt(values_, group));
  } else if (!found.is_compatible) {
    families_.add(group, 0, reason_of_conflict(values_, group));
  } else if (found.count == 0 && found_.is_empty()) {
    gaps_.fail(group);
  }
  const auto known = [&] {
    return std::tie(placed_.regularity, placed_.residual, placed_.derivatives_known,
                    placed_.path_known, placed_.rates_known);
  };
  const std::tuple<Status, double, bool, bool, bool> before = known();
  Squares squares{};
  const Visits visits = order_of_visits(group, found.count, squares);
  for (std::size_t visit = 0; visit < found.count && !found_.is_complete(); ++visit) {
    if (!nearness_.may_count(squares[visits[visit]])) {
      break;
    }
    known() = before;
    placement_.place(group, visits[visit]);
    descend(depth + 1);
  }
}

/// The order in which a group's configurations are visited: the nearest first if the nearest is
/// sought; in the group's own order if they are numbered group by group; otherwise as they were
/// found. `squares`: the contribution of each to the squared distance from the target, zero where
/// it is not computed yet.
Visits ConfigurationWalk::order_of_visits(GroupIndex group, std::size_t count, Squares& squares) {
  Visits order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (nearness_.is_sought()) {
    for (std::size_t index = 0; index < count; ++index) {
      placement_.stand(group, index);
      squares[index] = nearness_.square_of(group);
    }
    std::stable_sort(
        order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
        [&](std::size_t one, std::size_t other) { return squares[one] < squares[other]; });
  } else if (is_ordered_by_groups_ && count > 1) {
    group_order_.sort(group, count, order);
  }
  return order;
}

}  // namespace assur::mechanism::solve
