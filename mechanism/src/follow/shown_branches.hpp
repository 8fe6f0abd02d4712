// Turns the tracker's branches into those that rows and events report.
#pragma once

#include <set>
#include <span>
#include <vector>

#include "branch_tracker.hpp"
#include "unfollowed_interval.hpp"

namespace assur::mechanism::follow {

/// Whether a configuration has a row: it holds all constraints and is within all limits.
[[nodiscard]] inline bool is_told(const Configuration& state) {
  return state.is_consistent && state.within_limits;
}

/// Those of some branches that no event names, and that have no row in which their path is known.
[[nodiscard]] std::vector<int> untold(std::vector<int> branches, const std::vector<StepRow>& rows,
                                      std::span<const BranchEvent> events);

/// The branches that unresolved events name.
[[nodiscard]] std::set<int> left_unresolved(std::span<const BranchEvent> events);

/// Records which branches have had rows, and by which numbers they are shown.
class ShownBranches {
 public:
  /// `has_foreign`: whether there may be foreign branches, which violate the redundant constraints
  /// of the mechanism.
  explicit ShownBranches(bool has_foreign) : has_foreign_(has_foreign) {}

  /// Records that a branch has a row, or that it violates the redundant constraints.
  void note(const StepRow& row);
  [[nodiscard]] bool has_row(int branch) const { return told_.contains(branch); }
  [[nodiscard]] bool is_foreign(int branch) const { return foreign_.contains(branch); }
  /// Removes branches without rows from an event, since they are foreign. Returns whether the event
  /// still names a branch (for a crossing two), or named none from the first.
  [[nodiscard]] bool keeps_own(BranchEvent& event) const;
  /// Gives the branches of an event the numbers by which they are shown.
  void renumber(BranchEvent& event);
  /// The number by which a branch is shown; 0 for branch 0, which is no branch. Numbers are given
  /// as branches appear in rows and events: others may have ended before the sweep's first value,
  /// or be beyond the limits of joints throughout.
  [[nodiscard]] int shown(int branch);
  /// The same without giving a number: 0 for a branch that is not shown so far.
  [[nodiscard]] int shown_so_far(int branch) const {
    const auto place = static_cast<std::size_t>(branch);
    return place < numbers_.size() ? numbers_[place] : 0;
  }
  /// The tracker's numbers of the branches that are shown, in the order of those.
  [[nodiscard]] std::vector<int> in_order() const;
  /// How many are shown.
  [[nodiscard]] int count() const { return last_shown_; }

 private:
  bool has_foreign_;
  std::set<int> foreign_, told_;  ///< by the tracker's numbers
  std::vector<int> numbers_;      ///< as shown, by the tracker's; 0 if not yet
  int last_shown_ = 0;
};

}  // namespace assur::mechanism::follow
