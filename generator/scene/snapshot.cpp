#include "scene/snapshot.hpp"

#include <algorithm>
#include <cmath>

namespace assur::generator {

namespace {

/// Two configurations this close are not told apart safely: each is known to rounding / distance.
constexpr double closest = 5e-7;
/// A near-singular configuration that moves faster with the parameter than this stands on an event.
constexpr double steepest = 1e9;

/// The longest distance between two features of one link, which no motion changes; where no link
/// has two, the largest coordinate of a feature.
double length_of(const Scene& scene, const ParameterValues& values) {
  double longest = 0;
  double largest = 0;
  for (const SceneLink& link : scene.links) {
    std::vector<Eigen::Vector2d> points;
    for (const SceneFeature& feature : link.features) {
      points.emplace_back(values.value(feature.x).value(), values.value(feature.y).value());
      largest = std::max(largest, points.back().cwiseAbs().maxCoeff());
      for (const Eigen::Vector2d& other : points) {
        longest = std::max(longest, (points.back() - other).norm());
      }
    }
  }
  return longest > 0 ? longest : largest > 0 ? largest : 1;
}

ConfigurationPoint point_of_space(const AssemblyConfiguration& configuration,
                                  Eigen::Index parameter, double length) {
  const auto size = 4 * static_cast<Eigen::Index>(configuration.links.size());
  ConfigurationPoint point{Eigen::VectorXd(size), Eigen::VectorXd(size)};
  Eigen::Index row = 0;
  const auto add = [&](const Dual& coordinate, double unit) {
    point.at(row) = coordinate.value() / unit;
    point.slope(row) = coordinate.derivatives()(parameter) / unit;
    ++row;
  };
  for (const LinkState& link : configuration.links) {
    add(link.x, length);
    add(link.y, length);
    add(link.direction.cos, 1);
    add(link.direction.sin, 1);
  }
  return point;
}

bool is_separable(const Snapshot& snapshot) {
  if (snapshot.solution.status == SolutionStatus::degenerate || snapshot.solution.undecided > 0) {
    return false;
  }
  for (std::size_t one = 0; one < snapshot.count(); ++one) {
    const Eigen::VectorXd& slope = snapshot.points[one].slope;
    const bool suspect = snapshot.solution.configurations[one].regularity != Status::ok;
    if (!slope.allFinite() || (suspect && slope.norm() > steepest)) {
      return false;
    }
    for (std::size_t other = 0; other < one; ++other) {
      if ((snapshot.points[one].at - snapshot.points[other].at).norm() < closest) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

SnapshotSolver::SnapshotSolver(const Scene& scene) : scene_(scene) {
  const ParameterValues plain(scene);
  from_ = plain.value(scene.sweep->from).value();
  to_ = plain.value(scene.sweep->to).value();
  length_ = length_of(scene, ParameterValues(scene, std::pair(scene.sweep->parameter, from_)));
}

SnapshotPointer SnapshotSolver::at(double parameter) const {
  const ParameterValues values(scene_, std::pair(scene_.sweep->parameter, parameter));
  Snapshot snapshot{parameter, values, solve(scene_, values), {}, true};
  for (const AssemblyConfiguration& configuration : snapshot.solution.configurations) {
    snapshot.points.push_back(point_of_space(configuration, scene_.sweep->parameter, length_));
  }
  snapshot.separable = is_separable(snapshot);
  return std::make_shared<const Snapshot>(std::move(snapshot));
}

}  // namespace assur::generator
