// Numbered branches through successive sets of configurations, and the events between the sets.
#pragma once

#include <functional>
#include <vector>

#include "singular_event.hpp"
#include "snapshot_solver.hpp"

namespace assur::mechanism::follow {

/// An event with the numbers of its branches.
struct BranchEvent {
  EventKind kind;
  double parameter;
  std::vector<int> ended;  ///< of a crossing or a degenerate set: the branches that go through
  std::vector<int> begun;
  int through;  ///< 0 if none
  Configuration configuration;
  double uncertainty = 0;  ///< of the parameter, by rounding
};

/// Follows all branches from set to set and numbers them from 1 as they appear.
class BranchTracker {
 public:
  explicit BranchTracker(SnapshotSolver& solver) : solver_(solver) {}

  /// Starts with the first set, or the first one after a gap: every configuration begins a branch.
  void begin(const SnapshotPointer& set);
  /// Goes on to a set further along, which must be separable, and halves the interval until every
  /// branch and event in it is resolved.
  void advance(const SnapshotPointer& set);
  /// Ends all branches without a further set. Returns their numbers.
  std::vector<int> stop();

  [[nodiscard]] bool running() const { return current_ != nullptr; }
  [[nodiscard]] const SnapshotPointer& current() const { return current_; }
  /// The numbers of the current set's configurations.
  [[nodiscard]] const Table<PointIndex, int>& branches() const { return branches_; }
  /// Returns the events since the last call.
  [[nodiscard]] std::vector<BranchEvent> take_events();

 private:
  /// Goes on to a set if events explain the interval, and returns whether they do.
  [[nodiscard]] bool is_explained(const SnapshotPointer& set, BranchMatching matching,
                                  Explaining by);
  void adopt(const SnapshotPointer& set, const Table<PointIndex, PointIndex>& to_right,
             std::vector<SingularEvent> events);
  [[nodiscard]] SnapshotPointer between(const SnapshotPointer& set) const;
  void give_up(const SnapshotPointer& set, const BranchMatching& matching);

  SnapshotSolver& solver_;
  SnapshotPointer current_;
  Table<PointIndex, int> branches_;
  std::vector<BranchEvent> events_;
  int last_number_ = 0;
};

}  // namespace assur::mechanism::follow
