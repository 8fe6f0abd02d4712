// Branches that the rows and events of a sweep report, and their numbers.
#pragma once

#include <set>
#include <span>
#include <vector>

#include "branch_tracker.hpp"
#include "unfollowed_interval.hpp"

namespace assur::mechanism::follow {

/// Whether a configuration has a row: it satisfies all constraints and limits.
[[nodiscard]] inline bool is_told(const Configuration& state) {
  return state.is_consistent && state.within_limits;
}

/// The given branches that appear in no event and in no row with a known path.
[[nodiscard]] std::vector<int> untold(std::vector<int> branches, const std::vector<StepRow>& rows,
                                      std::span<const BranchEvent> events);

/// The branches in unresolved events.
[[nodiscard]] std::set<int> left_unresolved(std::span<const BranchEvent> events);

/// Records the branches with rows, and the numbers under which they are shown.
class ShownBranches {
 public:
  /// `has_foreign`: whether there may be foreign branches, which violate the mechanism's redundant
  /// constraints.
  explicit ShownBranches(bool has_foreign) : has_foreign_(has_foreign) {}

  /// Records that a branch has a row, or that it violates the redundant constraints.
  void note(const StepRow& row);
  [[nodiscard]] bool has_row(int branch) const { return told_.contains(branch); }
  [[nodiscard]] bool is_foreign(int branch) const { return foreign_.contains(branch); }
  /// Removes branches without rows from an event, since they are foreign. Returns whether the event
  /// still involves a branch (two for a crossing), or involved none from the start.
  [[nodiscard]] bool keeps_own(BranchEvent& event) const;
  /// Replaces the branches of an event by the numbers under which they are shown.
  void renumber(BranchEvent& event);
  /// The number under which a branch is shown; 0 for branch 0, which is no branch. Numbers are
  /// assigned as branches appear in rows and events: others may have ended before the sweep's first
  /// value, or be beyond the limits of joints throughout.
  [[nodiscard]] int shown(int branch);
  /// The same without assigning a number: 0 for a branch that is not shown so far.
  [[nodiscard]] int shown_so_far(int branch) const {
    const auto place = static_cast<std::size_t>(branch);
    return place < numbers_.size() ? numbers_[place] : 0;
  }
  /// The tracker's numbers of the shown branches, in the order of their shown numbers.
  [[nodiscard]] std::vector<int> in_order() const;
  /// The number of branches shown so far.
  [[nodiscard]] int count() const { return last_shown_; }

 private:
  bool has_foreign_;
  std::set<int> foreign_, told_;  ///< by the tracker's numbers
  std::vector<int> numbers_;      ///< as shown, by the tracker's; 0 if not yet
  int last_shown_ = 0;
};

}  // namespace assur::mechanism::follow
