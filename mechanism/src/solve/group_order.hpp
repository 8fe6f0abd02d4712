// Turns the configurations of a group where it is held into the order in which they are visited.
#pragma once

#include <array>
#include <vector>

#include "configuration_order.hpp"
#include "placement.hpp"

namespace assur::mechanism::solve {

/// The indices of a group's configurations among those that were found last, in the order of
/// visiting.
using Visits = std::array<std::size_t, models::most_configurations>;

/// Sorts the configurations of each group as those of a mechanism with that group alone are sorted.
class GroupOrder {
 public:
  /// The placement must outlive the order, which uses it to place the configurations that it
  /// compares.
  explicit GroupOrder(Placement& placement);

  /// Sorts the first `count` visits.
  void sort(GroupIndex group, std::size_t count, Visits& visits);

 private:
  Placement& placement_;
  Table<GroupIndex, NamedParts> parts_;
  std::vector<std::vector<double>> keys_;  ///< kept for their memory
};

}  // namespace assur::mechanism::solve
