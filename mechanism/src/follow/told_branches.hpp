// Turns the tracker's branches into those that rows and events name.
#pragma once

#include <set>
#include <span>
#include <vector>

#include "branch_tracker.hpp"
#include "passage.hpp"

namespace assur::mechanism::follow {

/// Whether a configuration has a row: it holds all constraints and is within all limits.
[[nodiscard]] inline bool is_told(const Configuration& state) {
  return state.is_consistent && state.within_limits;
}

/// Of these branches those that no event befalls, and that have no row in which their path is
/// known.
[[nodiscard]] std::vector<int> untold(std::vector<int> branches, const std::vector<StepRow>& rows,
                                      std::span<const BranchEvent> events);

/// Which branches have had rows, and by which numbers they are shown.
class ToldBranches {
 public:
  /// `has_foreign`: a mechanism with too many constraints has branches that do not hold them and
  /// are none of its own.
  explicit ToldBranches(bool has_foreign) : has_foreign_(has_foreign) {}

  /// That a branch has a row, or does not hold the constraints that are too many.
  void note(const StepRow& row);
  [[nodiscard]] bool has_row(int branch) const { return told_.contains(branch); }
  [[nodiscard]] bool is_foreign(int branch) const { return foreign_.contains(branch); }
  /// Leaves in an event the mechanism's own branches: those that have rows. Returns whether it
  /// befalls one, or two that cross, or named none from the first.
  [[nodiscard]] bool keeps_own(BranchEvent& event) const;
  /// Gives the branches of an event the numbers by which they are shown.
  void renumber(BranchEvent& event);
  /// The number by which a branch is shown, 0 of none. Numbers are given as branches appear in rows
  /// and events: others may have ended before the sweep's first value, or be beyond the limits of
  /// joints throughout.
  [[nodiscard]] int shown(int branch);
  /// How many are shown.
  [[nodiscard]] int count() const { return last_shown_; }

 private:
  bool has_foreign_;
  std::set<int> foreign_, told_;  ///< by the tracker's numbers
  std::vector<int> numbers_;      ///< as shown, by the tracker's; 0 if not yet
  int last_shown_ = 0;
};

}  // namespace assur::mechanism::follow
