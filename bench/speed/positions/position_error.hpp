// The position error of a list of configurations, infinite if one is lost or invented.
#pragma once

#include "positions/position_samples.hpp"

namespace assur::speed {

/// The largest error of a complete answer. A configuration is lost if no listed one is within its
/// tolerance, and invented if the list is longer than the true one.
template <typename Model>
[[nodiscard]] double position_error(const Found<Model>& found, const PositionTruth<Model>& truth) {
  double worst = 0;
  std::vector<bool> used(found.count, false);
  for (std::size_t place = 0; place < truth.list.size(); ++place) {
    double best = std::numeric_limits<double>::infinity();
    std::size_t chosen = 0;
    for (std::size_t index = 0; index < found.count; ++index) {
      const double distance = apart(found.list[index], truth.list[place]);
      if (!used[index] && distance < best) {
        best = distance;
        chosen = index;
      }
    }
    if (!(best < truth.tolerances[place])) {
      return std::numeric_limits<double>::infinity();
    }
    used[chosen] = true;
    worst = std::max(worst, best);
  }
  const bool complete = truth.list.size() == truth.count && found.count == truth.count;
  return complete ? worst : std::numeric_limits<double>::infinity();
}

}  // namespace assur::speed
