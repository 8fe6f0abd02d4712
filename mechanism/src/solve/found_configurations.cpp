#include "found_configurations.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "listed_configuration.hpp"
#include "plan/plan_data.hpp"
#include "plan/refusals.hpp"
#include "redundant_joints.hpp"
#include "search_bounds.hpp"

namespace assur::mechanism::solve {

FoundConfigurations::FoundConfigurations(Placement& placement, Nearness& nearness,
                                         const WatchedLimits& limits)
    : placement_(placement),
      placed_(placement.placed()),
      plan_(placement.plan()),
      values_(placement.values()),
      nearness_(nearness),
      limits_(limits),
      order_(plan_.named_parts),
      redundancy_(SettledRedundancy::made_for(values_)) {}

void FoundConfigurations::begin(const SearchOptions& search, std::size_t number, bool cuts,
                                Solution& result) {
  search_ = search;
  number_ = number;
  cuts_ = cuts;
  only_consistent_ = search.within_limits || !plan_.request.redundancy_tolerance.exists();
  solution_ = &result;
  result.status = SolutionStatus::ok;
  result.mobility = 0;
  result.reason.clear();
  result.incomplete.clear();
  result.dropped = 0;
  result.drop_reason.clear();
  result.breaches.clear();
  result.nearest_to_limits.reset();
  result.left_out = cuts ? std::nullopt : std::optional<std::size_t>(0);
  is_inconsistent_ = has_settled_ = is_unsure_ = false;
  least_gap_ = std::numeric_limits<double>::infinity();
  listed_ = passed_ = 0;
}

bool FoundConfigurations::lacks_all() const {
  return passed_ == 0 && listed_ == 0 && solution_->families.empty() &&
         solution_->left_out.value_or(0) == 0;
}

void FoundConfigurations::list() {
  placement_.turns().note_listed();
  const double gap = gap_of_redundant(values_, placed_.links, placed_.regularity);
  // Rounding may leave a larger gap after regular groups than after all constraints together.
  const bool is_certain =
      placed_.regularity == Status::ok &&
      (gap == 0 || gap_of_redundant(values_, placed_.links, Status::near_singular) > 0);
  if (!redundancy_ || is_certain) {
    list_placed(gap, !placed_.rates_known ||
                         goes_on_redundantly(values_, placed_.links, placed_.regularity));
    return;
  }
  const PlacedLinks without = placed_;
  has_settled_ = true;
  const double left = redundancy_->settle(placed_);
  is_unsure_ = is_unsure_ || left > 0;
  list_placed(left, redundancy_->goes_on());
  placed_ = without;
}

/// `gap`: the residual of the redundant constraints; `goes_on`: whether they continue to hold.
void FoundConfigurations::list_placed(double gap, bool goes_on) {
  const bool is_consistent = gap == 0 && goes_on;
  if (!is_consistent && only_consistent_) {
    is_inconsistent_ = true;
    least_gap_ = std::min(least_gap_, gap);
    return;
  }
  if (has_settled_ && is_consistent && !is_told_apart()) {
    return;
  }
  if (nearness_.is_sought()) {
    if (!nearness_.is_nearest()) {
      return;
    }
    listed_ = 0;
  }
  const bool keeps = !limits_.exist() || cuts_ || limits_.are_kept(solution_->breaches);
  if (!keeps && search_.within_limits) {
    ++*solution_->left_out;
    if (search_.measures_gap && listed_ == 0) {
      limits_.keep_nearest(solution_->nearest_to_limits);
    }
    return;
  }
  ++passed_;
  if (passed_ < number_) {
    return;
  }
  expect_room(values_, listed_);
  if (listed_ == solution_->configurations.size()) {
    solution_->configurations.emplace_back();
  }
  Configuration& result = solution_->configurations[listed_++];
  result.is_consistent = is_consistent;
  result.within_limits = keeps;
  write_configuration(placement_, search_.finds_motions, result);
}

/// Removes listed configurations that the placed one rules out; returns false if it is itself ruled
/// out.
bool FoundConfigurations::is_told_apart() {
  using Comparison = SettledRedundancy::Comparison;
  std::vector<Configuration>& all = solution_->configurations;
  for (std::size_t place = 0; place < listed_; ++place) {
    const Comparison found =
        redundancy_->compared(poses_of(all[place].links), poses_of(placed_.links));
    if (found == Comparison::second_is_none) {
      return false;
    }
    if (found == Comparison::first_is_none && !seeks_one()) {
      std::swap(all[place--], all[--listed_]);
      --passed_;
    }
  }
  return true;
}

std::optional<OverConstrained> FoundConfigurations::conclude(bool is_numbered, bool has_cut,
                                                             const ClosingGaps& gaps) {
  if (is_unsure_ && solution_->incomplete.empty()) {
    solution_->incomplete =
        "near a singular position, rounding decides whether further configurations exist";
  }
  if (passed_ > listed_) {  // a single configuration was sought, and there are others
    return std::nullopt;
  }
  if (is_inconsistent_ && lacks_all()) {
    OverConstrained refusal = plan::refusal_of_redundant(plan_, least_gap_);
    solution_->status = SolutionStatus::no_assembly;
    solution_->reason = refusal.what();
    return search_.within_limits ? std::optional(std::move(refusal)) : std::nullopt;
  }
  if (solution_->configurations.empty() && solution_->dropped > 0 && solution_->families.empty() &&
      search_.within_limits && solution_->left_out == 0) {
    throw MechanismError("", solution_->drop_reason);
  }
  if (solution_->configurations.empty()) {
    conclude_without_configurations(has_cut, gaps);
    return std::nullopt;
  }
  solution_->nearest_to_limits.reset();
  if (!is_numbered) {
    order_.sort(solution_->configurations);
  }
  return std::nullopt;
}

void FoundConfigurations::conclude_without_configurations(bool has_cut, const ClosingGaps& gaps) {
  if (solution_->families.empty()) {
    solution_->status = SolutionStatus::no_assembly;
    const std::string breaches = breaches_text(plan_.mechanism, solution_->breaches);
    solution_->reason = has_cut
                            ? "what can be assembled is beyond the limits of joints: " + breaches
                        : solution_->left_out > 0 ? reason_of_limits(*solution_->left_out, breaches)
                        : solution_->dropped > 0  ? solution_->drop_reason
                                                  : gaps.reason();
    return;
  }
  solution_->status = SolutionStatus::degenerate;
  const auto freest = std::max_element(
      solution_->families.begin(), solution_->families.end(),
      [](const Family& one, const Family& other) { return one.mobility < other.mobility; });
  solution_->mobility = freest->mobility;
  solution_->reason = freest->reason;
}

}  // namespace assur::mechanism::solve
