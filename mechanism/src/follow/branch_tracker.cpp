#include "branch_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "smooth_crossings.hpp"

namespace assur::mechanism::follow {

namespace {

/// The longest interval that events may explain, as a part of the sweep: a longer one may hide
/// further singular configurations beside the visible one.
constexpr double longest_explained = 1e-4;
/// Touching branches at this distance may be explained in an interval of any length. In a short
/// sweep they can no longer be distinguished once an interval has become as small a part of it as
/// above.
constexpr double close_by = 2e-5;
/// The shortest interval, as a part of the sweep and of the parameter's value.
constexpr double shortest = 1e-14;

/// Whether every branch goes through the interval and those that touch are close at both ends.
bool touches_closely(const BranchMatching& matching, const Snapshot& left, const Snapshot& right) {
  const auto is_close = [&](const TouchingPair& pair) {
    const auto apart = [](const Snapshot& set, PointIndex one, PointIndex other) {
      return (set.points[one].at - set.points[other].at).norm();
    };
    return apart(left, pair.one, pair.other) < close_by &&
           apart(right, matching.to_right[pair.one], matching.to_right[pair.other]) < close_by;
  };
  return matching.left_alone.empty() && matching.right_alone.empty() &&
         std::all_of(matching.touching.begin(), matching.touching.end(), is_close);
}

/// Whether every branch goes through the interval and some touch, so that they may cross.
bool goes_through(const BranchMatching& matching) {
  return matching.left_alone.empty() && matching.right_alone.empty() && !matching.touching.empty();
}

}  // namespace

void BranchTracker::begin(const SnapshotPointer& set) {
  current_ = set;
  branches_.assign(set->count(), 0);
  for (int& branch : branches_) {
    branch = ++last_number_;
  }
}

std::vector<int> BranchTracker::stop() {
  current_ = nullptr;
  const Table<PointIndex, int> ended = std::exchange(branches_, {});
  return ended.items();
}

std::vector<BranchEvent> BranchTracker::take_events() { return std::exchange(events_, {}); }

void BranchTracker::advance(const SnapshotPointer& set) {
  const BranchMatching matching = match(*current_, *set);
  if (matching.clear()) {
    adopt(set, matching.to_right, {});
    return;
  }
  if (auto crossed = smooth_crossings(solver_, current_, set, matching)) {
    adopt(set, crossed->to_right, std::move(crossed->crossings));
    return;
  }
  const double width = std::abs(set->parameter - current_->parameter);
  const bool is_short = width <= longest_explained * std::abs(solver_.to() - solver_.from()) ||
                        touches_closely(matching, *current_, *set);
  if ((is_short || goes_through(matching)) &&
      is_explained(set, matching, is_short ? Explaining::any_event : Explaining::crossings)) {
    return;
  }
  if (const SnapshotPointer middle = between(set)) {
    advance(middle);
    advance(set);
  } else if (!is_explained(set, matching, Explaining::all_that_is)) {
    give_up(set, matching);
  }
}

bool BranchTracker::is_explained(const SnapshotPointer& set, BranchMatching matching,
                                 Explaining by) {
  auto events = explain(solver_, current_, set, matching, by);
  if (events) {
    adopt(set, matching.to_right, std::move(*events));
  }
  return events.has_value();
}

/// A separable set near the middle of the interval; none if this is too short.
SnapshotPointer BranchTracker::between(const SnapshotPointer& set) const {
  const double from = current_->parameter;
  const double step = set->parameter - from;
  const double least = shortest * std::max(std::abs(solver_.to() - solver_.from()), std::abs(from));
  if (std::abs(step) < least) {
    return nullptr;
  }
  for (const double part : {0.5, 0.43, 0.58, 0.36, 0.65}) {
    if (SnapshotPointer middle = solver_.at(from + part * step); middle->separable) {
      return middle;
    }
  }
  return nullptr;
}

void BranchTracker::adopt(const SnapshotPointer& set, const Table<PointIndex, PointIndex>& to_right,
                          std::vector<SingularEvent> events) {
  Table<PointIndex, int> numbers(set->count(), 0);
  for (const PointIndex point : branches_.keys()) {
    if (to_right[point].exists()) {
      numbers[to_right[point]] = branches_[point];
    }
  }
  for (SingularEvent& event : events) {
    BranchEvent named{event.kind,       event.parameter, {}, {}, 0, std::move(event.configuration),
                      event.uncertainty};
    for (const PointIndex point : event.left) {
      named.ended.push_back(branches_[point]);
    }
    for (const PointIndex point : event.right) {
      numbers[point] = ++last_number_;
      named.begun.push_back(last_number_);
    }
    std::sort(named.ended.begin(), named.ended.end());
    if (event.through.exists()) {
      named.through = branches_[event.through];
    }
    events_.push_back(std::move(named));
  }
  branches_ = std::move(numbers);
  current_ = set;
}

/// Continues only the branches that are matched, touch no other and stay regular. All others end,
/// and new ones begin.
void BranchTracker::give_up(const SnapshotPointer& set, const BranchMatching& matching) {
  Table<PointIndex, PointIndex> to_right = matching.to_right;
  for (const TouchingPair& pair : matching.touching) {
    to_right[pair.one] = to_right[pair.other] = PointIndex();
  }
  for (const PointIndex point : matching.turned) {
    to_right[point] = PointIndex();
  }
  SingularEvent event{EventKind::unresolved,
                      (current_->parameter + set->parameter) / 2,
                      {},
                      {},
                      PointIndex(),
                      unknown_configuration(solver_.plan()),
                      std::abs(set->parameter - current_->parameter) / 2};
  Table<PointIndex, bool> continued(set->count(), false);
  for (const PointIndex point : to_right.keys()) {
    if (to_right[point].exists()) {
      continued[to_right[point]] = true;
    } else {
      event.left.push_back(point);
    }
  }
  for (const PointIndex point : continued.keys()) {
    if (!continued[point]) {
      event.right.push_back(point);
    }
  }
  adopt(set, to_right, {event});
}

}  // namespace assur::mechanism::follow
