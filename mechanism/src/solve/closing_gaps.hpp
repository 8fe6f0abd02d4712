// Turns the groups that fail to close, in one configuration of those before them after another,
// into the reason why a mechanism cannot be assembled.
#pragma once

#include <limits>
#include <set>
#include <string>
#include <vector>

#include "placement.hpp"

namespace assur::mechanism::solve {

/// By how much groups fail to close, while the configurations of a mechanism are sought.
class ClosingGaps {
 public:
  /// The placement must outlive it.
  explicit ClosingGaps(const Placement& placement);

  /// Forgets what was met; where nothing is measured all calls do nothing, which saves time.
  void begin(bool measures);
  /// A group is met with a choice of configurations of those that hold it.
  void meet(GroupIndex group);
  /// The group that was met last has no configuration there.
  void fail(GroupIndex group);
  /// Of the groups that cannot be assembled the one that fails by least is told. Empty if nothing
  /// was measured.
  [[nodiscard]] std::string reason() const;

 private:
  /// With which configurations of the groups that hold it a group was met, with which it fails to
  /// close, and by how much at least.
  struct Failures {
    std::set<std::vector<std::size_t>> met, failed;
    double least_gap = std::numeric_limits<double>::infinity();
    std::vector<std::string> holders;  ///< then: what holds it, and how it stands
  };

  [[nodiscard]] std::vector<std::size_t> choices_of(const std::vector<GroupIndex>& groups) const;
  /// The links that hold a group and stand as closures say, each with its angle, or by how much a
  /// law that reads a group has moved it.
  [[nodiscard]] std::vector<std::string> stance_of_holders(GroupIndex group) const;

  const Placement& placement_;
  const Structure& structure_;
  bool measures_ = false;
  Table<GroupIndex, Failures> failures_;
};

}  // namespace assur::mechanism::solve
