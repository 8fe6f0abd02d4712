#include "nearby_configurations.hpp"

#include <algorithm>
#include <cmath>

namespace assur::mechanism::solve {

double NearbyConfigurations::reach(const Configuration& configuration, LinkIndex link) const {
  constexpr double farthest = 0.5;  // where nothing is known of the link's motion
  // A link may turn faster on the way than at its beginning: where a pin passes a pivot closely,
  // it turns less than eight times as far as its speed tells, unless it passes `farthest`.
  constexpr double faster = 8;
  constexpr double least = 5e-4;  // where the link rests for a moment
  if (!configuration.path_known) {
    return farthest;
  }
  const double speed = std::abs(configuration.links[link].follows.first(2, column));
  return std::min(farthest, least + faster * speed * std::abs(way));
}

}  // namespace assur::mechanism::solve
