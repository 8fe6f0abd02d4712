#include "snapshot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace assur::mechanism::follow {

namespace {

/// Every pair of them is compared.
constexpr std::size_t most_followed = 1000;
/// Between two steps; a turn takes about a hundred.
constexpr int most_between_steps = 200000;

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

/// Where branches meet, and only there, derivatives lose their digits before places do: what has
/// its derivatives is apart from all others.
bool is_regular(const Snapshot& snapshot) {
  const auto& configurations = snapshot.solution.configurations;
  return snapshot.solution.status != SolutionStatus::degenerate &&
         std::all_of(configurations.begin(), configurations.end(),
                     [](const Configuration& one) { return one.path_known; }) &&
         std::all_of(snapshot.points.begin(), snapshot.points.end(),
                     [](const ConfigurationPoint& one) { return one.slope.allFinite(); });
}

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

}  // namespace

SnapshotSolver::SnapshotSolver(const Plan& plan, const Values& values)
    : plan_(plan), values_(values), solver_(values_) {
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

std::unique_ptr<Snapshot> SnapshotSolver::spare() const {
  if (spares_->empty()) {
    return std::make_unique<Snapshot>();
  }
  std::unique_ptr<Snapshot> snapshot = std::move(spares_->back());
  spares_->pop_back();
  return snapshot;
}

SnapshotPointer SnapshotSolver::at_step(double parameter) {
  between_steps_ = 0;
  return solved(parameter);
}

SnapshotPointer SnapshotSolver::solved(double parameter) {
  const Values& values = values_at(parameter);
  std::unique_ptr<Snapshot> snapshot = spare();
  snapshot->parameter = parameter;
  snapshot->spread = values.spread();
  snapshot->roles.resize(plan_.structure().groups.size());
  for (const GroupIndex group : snapshot->roles.keys()) {
    snapshot->roles[group] = values.group(group).roles;
  }
  solver_.solve({.within_limits = false}, snapshot->solution);
  if (snapshot->solution.configurations.size() > most_followed) {
    throw MechanismError("sweep", "more than " + std::to_string(most_followed) +
                                      " configurations at one value cannot be followed");
  }
  return completed(std::move(snapshot));
}

SnapshotPointer SnapshotSolver::at(double parameter) {
  if (++between_steps_ > most_between_steps) {
    throw MechanismError("sweep",
                         "between two steps the mechanism moves too far to be followed; "
                         "take more steps, or a shorter range");
  }
  try {
    return solved(parameter);
  } catch (const MechanismError& error) {
    // Between steps a formula may have no value.
    auto snapshot = std::make_unique<Snapshot>();
    snapshot->parameter = parameter;
    snapshot->solution.status = SolutionStatus::degenerate;
    snapshot->solution.reason = error.what();
    return completed(std::move(snapshot));
  }
}

SnapshotPointer SnapshotSolver::completed(std::unique_ptr<Snapshot> snapshot) const {
  snapshot->points.resize(snapshot->solution.configurations.size());
  for (const PointIndex point : snapshot->points.keys()) {
    set_point(snapshot->configuration(point), snapshot->points[point]);
  }
  snapshot->closest = least_distance(snapshot->points);
  snapshot->separable = is_regular(*snapshot);
  return {snapshot.release(), [spares = spares_](Snapshot* gone) { spares->emplace_back(gone); }};
}

void SnapshotSolver::set_point(const Configuration& configuration,
                               ConfigurationPoint& point) const {
  const auto size = 4 * static_cast<Eigen::Index>(configuration.links.size());
  point.at.resize(size);
  point.slope.resize(size);
  Eigen::Index row = 0;
  for (const Frame& link : configuration.links) {
    const Direction<double>& direction = link.pose.direction;
    const auto slope = link.follows.first.col(column_);
    point.at.segment<4>(row) << link.pose.x / length_, link.pose.y / length_, direction.cos,
        direction.sin;
    point.slope.segment<4>(row) << slope(0) / length_, slope(1) / length_,
        -slope(2) * direction.sin, slope(2) * direction.cos;
    row += 4;
  }
}

}  // namespace assur::mechanism::follow
