#include "scene/branch_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace assur::generator {

namespace {

/// The longest interval, as a part of the sweep, that events may explain: beside a singular
/// configuration others may be that a longer one does not show.
constexpr double longest_explained = 1e-4;
/// The shortest interval, as a part of the sweep and of the parameter's value.
constexpr double shortest = 1e-13;

std::size_t slot(int index) { return static_cast<std::size_t>(index); }

}  // namespace

void BranchTracker::begin(const SnapshotPointer& set) {
  current_ = set;
  branches_.clear();
  for (std::size_t index = 0; index < set->count(); ++index) {
    branches_.push_back(++last_number_);
  }
}

std::vector<int> BranchTracker::stop() {
  current_ = nullptr;
  return std::exchange(branches_, {});
}

std::vector<BranchEvent> BranchTracker::take_events() { return std::exchange(events_, {}); }

void BranchTracker::advance(const SnapshotPointer& set) {
  BranchMatching matching = match(*current_, *set);
  if (matching.clear()) {
    adopt(set, matching.to_right, {});
    return;
  }
  const double width = std::abs(set->parameter - current_->parameter);
  if (width <= longest_explained * std::abs(solver_.to() - solver_.from())) {
    if (auto events = explain(solver_, current_, set, matching)) {
      adopt(set, matching.to_right, std::move(*events));
      return;
    }
  }
  if (const SnapshotPointer middle = between(set)) {
    advance(middle);
    advance(set);
  } else {
    give_up(set, matching);
  }
}

/// A separable set near the middle of the interval, unless this is too short.
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

void BranchTracker::adopt(const SnapshotPointer& set, const std::vector<int>& to_right,
                          std::vector<SingularEvent> events) {
  std::vector<int> numbers(set->count(), 0);
  for (std::size_t index = 0; index < branches_.size(); ++index) {
    if (to_right[index] >= 0) {
      numbers[slot(to_right[index])] = branches_[index];
    }
  }
  for (SingularEvent& event : events) {
    BranchEvent named{event.kind, event.parameter, {}, {}, 0, std::move(event.configuration)};
    for (const int index : event.left) {
      named.ended.push_back(branches_[slot(index)]);
    }
    for (const int index : event.right) {
      numbers[slot(index)] = ++last_number_;
      named.begun.push_back(last_number_);
    }
    std::sort(named.ended.begin(), named.ended.end());
    if (event.through >= 0) {
      named.through = branches_[slot(event.through)];
    }
    events_.push_back(std::move(named));
  }
  branches_ = std::move(numbers);
  current_ = set;
}

/// Goes on only with what is matched and touches nothing; the rest ends and begins.
void BranchTracker::give_up(const SnapshotPointer& set, const BranchMatching& matching) {
  std::vector<int> to_right = matching.to_right;
  for (const TouchingPair& pair : matching.touching) {
    to_right[slot(pair.one)] = to_right[slot(pair.other)] = -1;
  }
  SingularEvent event{EventKind::unresolved,
                      (current_->parameter + set->parameter) / 2,
                      {},
                      {},
                      -1,
                      unknown_configuration(solver_.scene())};
  std::vector<bool> continued(set->count(), false);
  for (std::size_t index = 0; index < to_right.size(); ++index) {
    if (to_right[index] < 0) {
      event.left.push_back(static_cast<int>(index));
    } else {
      continued[slot(to_right[index])] = true;
    }
  }
  for (std::size_t index = 0; index < continued.size(); ++index) {
    if (!continued[index]) {
      event.right.push_back(static_cast<int>(index));
    }
  }
  adopt(set, to_right, {event});
}

}  // namespace assur::generator
