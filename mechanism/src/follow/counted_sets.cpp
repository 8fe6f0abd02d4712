#include "counted_sets.hpp"

#include <algorithm>
#include <cmath>

namespace assur::mechanism::follow {

namespace {

/// The largest number of sets kept for counting turns.
constexpr std::size_t most_counted = 2048;

}  // namespace

bool has_counted_angles(const Snapshot& snapshot) {
  return std::ranges::any_of(snapshot.solution.configurations,
                             [](const Configuration& one) { return !one.counted.empty(); });
}

const SnapshotPointer& CountedSets::nearest(double parameter) const {
  return *std::ranges::min_element(sets_, {}, [parameter](const SnapshotPointer& set) {
    return std::abs(set->parameter - parameter);
  });
}

void CountedSets::note(const SnapshotPointer& set, bool is_ambiguous) {
  const bool is_gap = set->count() == 0 && !set->is_degenerate() && reads_angles_;
  const bool is_known = is_gap || (has_counted_angles(*set) && is_regular(*set));
  if (is_known && !is_ambiguous) {
    if (sets_.size() == most_counted) {
      sets_.erase(sets_.begin());
    }
    sets_.push_back(set);
  }
}

void CountedSets::count_from(const SnapshotPointer& set) {
  if (has_counted_angles(*set)) {
    sets_ = {set};
  }
}

std::vector<solve::NearbyConfigurations> CountedSets::beside(double parameter, double from) const {
  const Snapshot* below = nullptr;
  const Snapshot* above = nullptr;
  for (const SnapshotPointer& set : sets_) {
    if (set->parameter <= parameter) {
      below = below == nullptr || below->parameter < set->parameter ? set.get() : below;
    } else {
      above = above == nullptr || above->parameter > set->parameter ? set.get() : above;
    }
  }
  std::vector<solve::NearbyConfigurations> nearby;
  for (const Snapshot* set : {below, above}) {
    if (set != nullptr) {
      nearby.push_back({&set->solution.configurations, &set->roles, column_,
                        parameter - set->parameter, set->parameter == from});
    }
  }
  return nearby;
}

}  // namespace assur::mechanism::follow
