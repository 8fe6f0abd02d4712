// Order in which the configurations of a held group are visited.
#pragma once

#include <array>
#include <vector>

#include "configuration_order.hpp"
#include "placement.hpp"

namespace assur::mechanism::solve {

/// The indices of the group's configurations found last, in the order of visiting.
using Visits = std::array<std::size_t, models::most_configurations>;

/// Sorts the configurations of each group as those of a mechanism with that group alone.
class GroupOrder {
 public:
  /// The placement must outlive the order, which places the compared configurations in it.
  explicit GroupOrder(Placement& placement);

  /// Sorts the first `count` visits.
  void sort(GroupIndex group, std::size_t count, Visits& visits);

 private:
  Placement& placement_;
  Table<GroupIndex, NamedParts> parts_;
  std::vector<std::vector<double>> keys_;  ///< kept for their memory
};

}  // namespace assur::mechanism::solve
