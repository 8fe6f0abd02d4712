#include "snapshot.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

namespace assur::mechanism::follow {

// The line has parts of the golden ratio along the coordinates, so that no two motions that differ
// by the sign of a coordinate have the same place on it.
double OrderOnLine::place_of(const Eigen::VectorXd& point) {
  double place = 0;
  double part = 0;
  for (const double coordinate : point) {
    part = std::fmod(part + std::numbers::phi, 1.0);
    place += part * coordinate;
  }
  return place / std::sqrt(std::max<double>(1, static_cast<double>(point.size())));
}

double least_distance(const Table<PointIndex, ConfigurationPoint>& points) {
  const OrderOnLine order(points.size(), [&](PointIndex point) { return points[point].at; });
  double square = std::numeric_limits<double>::infinity();
  for (auto one = order.places().begin(); one != order.places().end(); ++one) {
    for (auto other = std::next(one); other != order.places().end(); ++other) {
      const double apart = other->place - one->place;
      if (apart * apart > square) {
        break;
      }
      square = std::min(square, (points[one->point].at - points[other->point].at).squaredNorm());
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
