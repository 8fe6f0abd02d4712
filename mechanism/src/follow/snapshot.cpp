#include "snapshot.hpp"

#include <algorithm>
#include <cmath>

namespace assur::mechanism::follow {

namespace {

/// Two configurations this close are not told apart safely: each is known to rounding / distance.
constexpr double closest = 5e-7;
/// A near-singular configuration that moves faster with the parameter than this stands on an event.
constexpr double steepest = 1e6;

/// The longest distance between two features of one link, which no motion changes; where no link
/// has two, the largest coordinate of a feature.
double length_of(const Mechanism& mechanism, const Values& values) {
  double longest = 0;
  double largest = 0;
  for (const Link& link : mechanism.links()) {
    std::vector<Eigen::Vector2d> points;
    for (const FeatureIndex feature : link.features) {
      if (values.frame(feature).follows.first.cols() == 0) {
        continue;  // no joint and no output has it
      }
      const Pose<double>& place = values.frame(feature).pose;
      points.emplace_back(place.x, place.y);
      largest = std::max(largest, points.back().cwiseAbs().maxCoeff());
      for (const Eigen::Vector2d& other : points) {
        longest = std::max(longest, (points.back() - other).norm());
      }
    }
  }
  return longest > 0 ? longest : largest > 0 ? largest : 1;
}

bool is_separable(const Snapshot& snapshot) {
  if (snapshot.solution.status == SolutionStatus::degenerate) {
    return false;
  }
  for (const PointIndex one : snapshot.points.keys()) {
    const Eigen::VectorXd& slope = snapshot.points[one].slope;
    const bool suspect = snapshot.configuration(one).regularity != Status::ok;
    if (!slope.allFinite() || (suspect && slope.norm() > steepest)) {
      return false;
    }
    for (const PointIndex other : snapshot.points.keys()) {
      if (other < one && (snapshot.points[one].at - snapshot.points[other].at).norm() < closest) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

SnapshotSolver::SnapshotSolver(const Plan& plan, const Values& values)
    : plan_(plan), values_(values) {
  const std::vector<ParameterIndex>& columns = values_.columns();
  column_ = std::find(columns.begin(), columns.end(), sweep().parameter) - columns.begin();
  from_ = values_.value_of(sweep().from);
  to_ = values_.value_of(sweep().to);
  length_ = length_of(plan.mechanism(), values_at(from_));
}

const Values& SnapshotSolver::values_at(double parameter) {
  values_.set(sweep().parameter, parameter);
  return values_;
}

SnapshotPointer SnapshotSolver::at_step(double parameter) {
  const Values& values = values_at(parameter);
  Snapshot snapshot{parameter, values.spread(), {}, {}, {}, true};
  for (const GroupIndex group : plan_.structure().groups.keys()) {
    snapshot.roles.add(values.group(group).roles);
  }
  if (!spares_->empty()) {
    snapshot.solution = std::move(spares_->back());
    spares_->pop_back();
  }
  plan_.solve(values, snapshot.solution);
  return completed(std::move(snapshot));
}

SnapshotPointer SnapshotSolver::at(double parameter) {
  try {
    return at_step(parameter);
  } catch (const MechanismError& error) {
    // Between steps a formula may have no value.
    Snapshot snapshot{parameter, {}, {}, {}, {}, true};
    snapshot.solution.status = SolutionStatus::degenerate;
    snapshot.solution.reason = error.what();
    return completed(std::move(snapshot));
  }
}

SnapshotPointer SnapshotSolver::completed(Snapshot snapshot) const {
  snapshot.points.reserve(snapshot.solution.configurations.size());
  for (const Configuration& configuration : snapshot.solution.configurations) {
    snapshot.points.add(point_of_space(configuration));
  }
  snapshot.separable = is_separable(snapshot);
  return {new Snapshot(std::move(snapshot)), [spares = spares_](Snapshot* gone) {
            spares->push_back(std::move(gone->solution));
            delete gone;
          }};
}

ConfigurationPoint SnapshotSolver::point_of_space(const Configuration& configuration) const {
  const auto size = 4 * static_cast<Eigen::Index>(configuration.links.size());
  ConfigurationPoint point{Eigen::VectorXd(size), Eigen::VectorXd(size)};
  Eigen::Index row = 0;
  for (const Frame& link : configuration.links) {
    const Direction<double>& direction = link.pose.direction;
    const Eigen::Vector3d slope = link.follows.first.col(column_);
    point.at.segment<4>(row) << link.pose.x / length_, link.pose.y / length_, direction.cos,
        direction.sin;
    point.slope.segment<4>(row) << slope(0) / length_, slope(1) / length_,
        -slope(2) * direction.sin, slope(2) * direction.cos;
    row += 4;
  }
  return point;
}

}  // namespace assur::mechanism::follow
