// Turns the configurations of a group where it is held into the order in which they are visited.
#pragma once

#include <array>
#include <vector>

#include "configuration_order.hpp"
#include "placement.hpp"

namespace assur::mechanism::solve {

/// The places of a group's configurations among those that were found last.
using Visits = std::array<std::size_t, models::most_configurations>;

/// Orders the configurations of each group as those of a mechanism of that group alone are ordered.
class GroupOrder {
 public:
  /// The placement must outlive the order; it places what is compared.
  explicit GroupOrder(Placement& placement);

  /// Puts the first `count` visits in order.
  void sort(GroupIndex group, std::size_t count, Visits& visits);

 private:
  Placement& placement_;
  Table<GroupIndex, NamedParts> parts_;
  std::vector<std::vector<double>> keys_;  ///< room for them
};

}  // namespace assur::mechanism::solve
