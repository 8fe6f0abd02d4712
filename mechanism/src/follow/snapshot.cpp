#include "snapshot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace assur::mechanism::follow {

double least_distance(const Table<PointIndex, ConfigurationPoint>& points) {
  double square = std::numeric_limits<double>::infinity();
  for (const PointIndex one : points.keys()) {
    for (const PointIndex other : points.keys()) {
      if (other < one) {
        square = std::min(square, (points[one].at - points[other].at).squaredNorm());
      }
    }
  }
  return std::sqrt(square);
}

// Where branches meet, and only there, derivatives lose their digits before places do, so that
// configurations with derivatives are apart from one another.
bool is_regular(const Snapshot& snapshot) {
  const auto& configurations = snapshot.solution.configurations;
  return snapshot.solution.status != SolutionStatus::degenerate &&
         std::all_of(configurations.begin(), configurations.end(),
                     [](const Configuration& one) { return one.path_known; }) &&
         std::all_of(snapshot.points.begin(), snapshot.points.end(),
                     [](const ConfigurationPoint& one) { return one.slope.allFinite(); });
}

}  // namespace assur::mechanism::follow
