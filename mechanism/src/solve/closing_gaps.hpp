// Gaps by which groups fail to close, and the reason why a mechanism cannot be assembled.
#pragma once

#include <limits>
#include <set>
#include <string>
#include <vector>

#include "placement.hpp"

namespace assur::mechanism::solve {

/// Records the gaps by which groups fail to close during a search.
class ClosingGaps {
 public:
  /// The placement must outlive it.
  explicit ClosingGaps(const Placement& placement);

  /// Discards earlier records. Without `measures` all other calls do nothing, which saves time.
  void begin(bool measures);
  /// Records that the search has reached a group, with the present choices of the groups that hold
  /// it.
  void meet(GroupIndex group);
  /// Records that the group has no configuration there, and by how much it fails to close.
  void fail(GroupIndex group);
  /// Whether a group without a configuration might have one at the exact position of its
  /// neighbours: these are displaced by up to the square root of rounding where two of their
  /// configurations are listed as one.
  [[nodiscard]] bool is_in_doubt(GroupIndex group) const;
  /// One sentence that names the group with the least gap among those that cannot be assembled;
  /// empty if nothing was measured.
  [[nodiscard]] std::string reason() const;

 private:
  /// Choices of the holding groups' configurations at which a group was reached, those at which it
  /// fails to close, and its least gap.
  struct Failures {
    std::set<std::vector<std::size_t>> met, failed;
    double least_gap = std::numeric_limits<double>::infinity();
    std::vector<std::string>
        holders;  ///< at the least gap: the links that hold it, and their angles
  };

  [[nodiscard]] std::vector<std::size_t> choices_of(const std::vector<GroupIndex>& groups) const;
  /// The links that hold a group and are placed by closures, each with its angle, or with the
  /// displacement that a law gives it.
  [[nodiscard]] std::vector<std::string> stance_of_holders(GroupIndex group) const;

  const Placement& placement_;
  const Structure& structure_;
  bool measures_ = false;
  Table<GroupIndex, Failures> failures_;
};

}  // namespace assur::mechanism::solve
