#include "meeting_pairs.hpp"

#include <algorithm>
#include <limits>

namespace assur::mechanism::follow {

namespace {

/// The largest separation of a pair that folds with a third branch through it, and the largest
/// offset of the third from its middle.
constexpr double through_separation = 2e-3;
constexpr double through_offset = 0.02;

/// Whether two branches run head-on: shortly before the meeting they move towards each other, and
/// their middle hardly moves.
bool head_on(const ConfigurationPair& pair) {
  const Eigen::VectorXd& one = pair.first().slope;
  const Eigen::VectorXd& other = pair.second().slope;
  return (one + other).norm() < 0.05 * (one.norm() + other.norm());
}

/// Whether a branch meets another one of `alone` in the middle of the pair.
bool meets_there(PointIndex point, const ConfigurationPair& pair,
                 const std::vector<PointIndex>& alone) {
  const auto is_alone = [&](PointIndex index) {
    return std::find(alone.begin(), alone.end(), index) != alone.end();
  };
  return is_alone(point) && std::any_of(alone.begin(), alone.end(), [&](PointIndex other) {
           const ConfigurationPair there{pair.set, point, other};
           const Eigen::VectorXd offset =
               (there.first().at + there.second().at - pair.first().at - pair.second().at) / 2;
           return other != point && head_on(there) && offset.norm() < 0.1 * there.separation();
         });
}

}  // namespace

std::pair<PointIndex, PointIndex> meeting(const Side& side, const std::vector<PointIndex>& among) {
  std::pair<PointIndex, PointIndex> best{among[0], among[1]};
  double least = std::numeric_limits<double>::infinity();
  bool best_is_head_on = false;
  for (const PointIndex one : among) {
    for (const PointIndex other : among) {
      if (!(one < other)) {
        continue;
      }
      const ConfigurationPair pair{side.near, one, other};
      const bool is_head_on = head_on(pair) && side.reaches(pair.distance_to_fold(), 0.1);
      const double distance = pair.separation();
      if (is_head_on == best_is_head_on ? distance < least : is_head_on) {
        least = distance;
        best = {one, other};
        best_is_head_on = is_head_on;
      }
    }
  }
  return best;
}

bool is_apart_from_others(const ConfigurationPair& pair, double distance,
                          const std::vector<PointIndex>& alone, PointIndex& through) {
  const double separation = pair.separation();
  const Eigen::VectorXd middle = (pair.first().at + pair.second().at) / 2;
  const Eigen::VectorXd middle_slope = (pair.first().slope + pair.second().slope) / 2;
  for (const PointIndex other : pair.set->points.keys()) {
    if (other == pair.one || other == pair.other) {
      continue;
    }
    const ConfigurationPoint& point = pair.set->points[other];
    const Eigen::VectorXd offset = point.at - middle;
    const Eigen::VectorXd later = offset + distance * (point.slope - middle_slope);
    if ((offset.norm() > 2 * separation && later.norm() > separation) ||
        (head_on(pair) && meets_there(other, pair, alone))) {
      continue;
    }
    if (through.exists() || separation > through_separation ||
        offset.norm() > through_offset * separation) {
      return false;
    }
    through = other;
  }
  return true;
}

}  // namespace assur::mechanism::follow
