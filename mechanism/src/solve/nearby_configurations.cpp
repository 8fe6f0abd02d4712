#include "nearby_configurations.hpp"

#include <algorithm>
#include <assur/directions.hpp>
#include <cmath>

namespace assur::mechanism::solve {

namespace {

double distance(const Direction<double>& one, const Direction<double>& other) {
  return std::hypot(one.cos - other.cos, one.sin - other.sin);
}

}  // namespace

void Continuation::add(const NearbyConfigurations& nearby, const Configuration& there,
                       LinkIndex link, const Direction<double>& here) {
  constexpr double farthest = 0.5;  // the largest turn along a slope, in radians
  constexpr double faster = 8;      // the factor by which a link may turn faster later on the way
  constexpr double least = 5e-4;    // for a link that rests for a moment
  const Direction<double>& from = there.links[link].pose.direction;
  const double turn = there.links[link].follows.first(2, nearby.column) * nearby.way;
  const bool is_led = there.path_known && std::abs(turn) < farthest;
  error += distance(here, is_led ? turned(from, direction_of(turn)) : from);
  away += distance(here, from);
  reach += is_led ? std::min(farthest, least + faster * std::abs(turn)) : farthest;
}

}  // namespace assur::mechanism::solve
