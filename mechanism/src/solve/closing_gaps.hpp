// Turns the groups that fail to close, for each choice of the configurations before them, into the
// reason why a mechanism cannot be assembled.
#pragma once

#include <limits>
#include <set>
#include <string>
#include <vector>

#include "placement.hpp"

namespace assur::mechanism::solve {

/// Records by how much groups fail to close while the configurations of a mechanism are sought.
class ClosingGaps {
 public:
  /// The placement must outlive it.
  explicit ClosingGaps(const Placement& placement);

  /// Forgets what was recorded. Without `measures` all other calls do nothing, which saves time.
  void begin(bool measures);
  /// Records that the search has reached a group, with the present choices of the groups that hold
  /// it.
  void meet(GroupIndex group);
  /// Records that the group has no configuration there, and by how much it fails to close.
  void fail(GroupIndex group);
  /// Whether a group that has no configuration where it is held may have one where its neighbours
  /// truly are: their places may be wrong by the square root of rounding where two of their
  /// configurations are listed as one.
  [[nodiscard]] bool is_in_doubt(GroupIndex group) const;
  /// One sentence on the group that cannot be assembled and fails by the least gap; empty if
  /// nothing was measured.
  [[nodiscard]] std::string reason() const;

 private:
  /// The choices of the holding groups' configurations with which a group was reached, those with
  /// which it fails to close, and its least gap.
  struct Failures {
    std::set<std::vector<std::size_t>> met, failed;
    double least_gap = std::numeric_limits<double>::infinity();
    std::vector<std::string>
        holders;  ///< at the least gap: the links that hold it, and their angles
  };

  [[nodiscard]] std::vector<std::size_t> choices_of(const std::vector<GroupIndex>& groups) const;
  /// The links that hold a group and are placed by closures, each with its angle, or with the
  /// displacement that a law which reads a group gives it.
  [[nodiscard]] std::vector<std::string> stance_of_holders(GroupIndex group) const;

  const Placement& placement_;
  const Structure& structure_;
  bool measures_ = false;
  Table<GroupIndex, Failures> failures_;
};

}  // namespace assur::mechanism::solve
