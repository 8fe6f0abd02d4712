#include "event_location.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace assur::mechanism::follow {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Weights of the values at `nodes` in the interpolating polynomial's value at zero.
Eigen::VectorXd weights_at_zero(const Eigen::VectorXd& nodes) {
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(nodes.size());
  for (Eigen::Index one = 0; one < nodes.size(); ++one) {
    for (Eigen::Index other = 0; other < nodes.size(); ++other) {
      if (one != other) {
        weights(one) *= nodes(other) / (nodes(other) - nodes(one));
      }
    }
  }
  return weights;
}

/// The weighted sum of configurations; rates and gradients stay unknown.
class Blend {
 public:
  explicit Blend(const Plan& plan) : sum_(unknown_configuration(plan)) {
    for (Frame& link : sum_.links) {
      link.pose = {0, 0, {0, 0}};
    }
    for (Point& point : sum_.outputs) {
      point.position.setZero();
    }
    sum_.residual = 0;
  }

  void add(const Configuration& configuration, double weight) {
    for (const LinkIndex link : sum_.links.keys()) {
      Pose<double>& total = sum_.links[link].pose;
      const Pose<double>& part = configuration.links[link].pose;
      total.x += weight * part.x;
      total.y += weight * part.y;
      total.direction.cos += weight * part.direction.cos;
      total.direction.sin += weight * part.direction.sin;
    }
    for (const OutputIndex output : sum_.outputs.keys()) {
      sum_.outputs[output].position += weight * configuration.outputs[output].position;
    }
  }

  [[nodiscard]] Configuration result() const {
    Configuration blended = sum_;
    for (Frame& link : blended.links) {
      Direction<double>& direction = link.pose.direction;
      const double length = std::hypot(direction.cos, direction.sin);
      direction = {direction.cos / length, direction.sin / length};
    }
    return blended;
  }

 private:
  Configuration sum_;
};

/// The point of a set that is nearest to a place; none of an empty set.
PointIndex nearest(const Snapshot& set, const Eigen::VectorXd& place) {
  PointIndex best;
  double least = std::numeric_limits<double>::infinity();
  for (const PointIndex point : set.points.keys()) {
    const double distance = (set.points[point].at - place).norm();
    if (distance < least) {
      least = distance;
      best = point;
    }
  }
  return best;
}

/// The pair that is nearest to two predicted places, each missed by less than `tolerance`.
std::optional<ConfigurationPair> pair_near(const SnapshotPointer& set, const Eigen::VectorXd& one,
                                           const Eigen::VectorXd& other, double tolerance) {
  const ConfigurationPair pair{set, nearest(*set, one), nearest(*set, other)};
  if (!pair.one.exists() || pair.one == pair.other ||
      !((pair.first().at - one).norm() < tolerance &&
        (pair.second().at - other).norm() < tolerance)) {
    return std::nullopt;
  }
  return pair;
}

/// The pair at another distance from its fold: half-way between the two moves smoothly, and their
/// separation is as the root of the distance.
std::optional<ConfigurationPair> followed(SnapshotSolver& solver, const ConfigurationPair& pair,
                                          double parameter) {
  if (!solver.covers(parameter)) {
    return std::nullopt;
  }
  const double distance = pair.distance_to_fold();
  const double move = parameter - pair.set->parameter;
  const double shrink = std::sqrt((distance - move) / distance);
  if (!(shrink > 0)) {
    return std::nullopt;
  }
  const Eigen::VectorXd middle = (pair.first().at + pair.second().at) / 2 +
                                 (pair.first().slope + pair.second().slope) / 2 * move;
  const Eigen::VectorXd half = pair.apart() / 2 * shrink;
  constexpr double tolerance = 0.3;
  return pair_near(solver.at(parameter), middle - half, middle + half,
                   tolerance * pair.separation() * shrink);
}

/// Follows a pair towards its fold until its separation is about `target`.
std::optional<ConfigurationPair> approached(SnapshotSolver& solver, ConfigurationPair pair,
                                            double target) {
  constexpr int most = 60;
  for (int iteration = 0; iteration < most && pair.separation() > 1.5 * target; ++iteration) {
    const double part = std::max(1.0 / 16, std::pow(target / pair.separation(), 2));
    const auto next =
        followed(solver, pair, pair.set->parameter + pair.distance_to_fold() * (1 - part));
    if (!next) {
      return std::nullopt;
    }
    pair = *next;
  }
  return pair;
}

/// One width of a fold's interpolation, and what its widest pair contributed: about what the next
/// narrower width would change.
struct FoldEstimate {
  EventLocation location;
  double change;
};

/// Interpolates over pairs up to a separation, which truncates at its eighth power.
std::optional<FoldEstimate> fold_at_separation(SnapshotSolver& solver,
                                               const ConfigurationPair& near, double target) {
  const auto start = approached(solver, near, target);
  if (!start) {
    return std::nullopt;
  }
  constexpr int pairs = 4;
  const double distance = start->distance_to_fold();
  const double estimate = start->set->parameter + distance;
  const double widest = distance * std::pow(target / start->separation(), 2);
  std::array<ConfigurationPair, pairs> found{};
  for (int index = 0; index < pairs; ++index) {
    const double part = static_cast<double>(index + 1) / pairs;
    const double parameter = estimate - widest * part * part;
    const auto pair = followed(solver, *start, parameter);
    if (!pair) {
      return std::nullopt;
    }
    found[static_cast<std::size_t>(index)] = *pair;
  }
  const Eigen::VectorXd along = found.back().apart().normalized();
  Eigen::VectorXd nodes(2 * pairs);
  for (Eigen::Index index = 0; index < pairs; ++index) {
    const ConfigurationPair& pair = found[static_cast<std::size_t>(index)];
    nodes(2 * index) = 1 / along.dot(pair.first().slope);
    nodes(2 * index + 1) = 1 / along.dot(pair.second().slope);
  }
  const Eigen::VectorXd weights = weights_at_zero(nodes);
  Eigen::VectorXd change_of_weights = weights;
  change_of_weights.head(nodes.size() - 2) -= weights_at_zero(nodes.head(nodes.size() - 2));
  double shift = 0;
  double change_of_shift = 0;
  Eigen::VectorXd change_of_place = Eigen::VectorXd::Zero(along.size());
  Blend blend(solver.plan());
  for (Eigen::Index index = 0; index < pairs; ++index) {
    const ConfigurationPair& pair = found[static_cast<std::size_t>(index)];
    const auto of_pair = [index](const Eigen::VectorXd& all) { return all.segment<2>(2 * index); };
    shift += of_pair(weights).sum() * (pair.set->parameter - estimate);
    blend.add(pair.set->configuration(pair.one), of_pair(weights)(0));
    blend.add(pair.set->configuration(pair.other), of_pair(weights)(1));
    change_of_shift += of_pair(change_of_weights).sum() * (pair.set->parameter - estimate);
    change_of_place += of_pair(change_of_weights)(0) * pair.first().at +
                       of_pair(change_of_weights)(1) * pair.second().at;
  }
  if (!(std::abs(shift) < 0.1 * std::abs(widest))) {
    return std::nullopt;
  }
  return FoldEstimate{{estimate + shift, blend.result()},
                      change_of_place.norm() + std::abs(change_of_shift / widest) * target};
}

}  // namespace

const ConfigurationPoint& ConfigurationPair::first() const { return set->points[one]; }
const ConfigurationPoint& ConfigurationPair::second() const { return set->points[other]; }

double ConfigurationPair::distance_to_fold() const {
  const Eigen::VectorXd difference = apart();
  return -difference.squaredNorm() / (2 * difference.dot(second().slope - first().slope));
}

Configuration unknown_configuration(const Plan& plan) {
  const auto count = static_cast<Eigen::Index>(plan.values().columns().size());
  Frame link;
  link.pose = {unknown, unknown, {unknown, unknown}};
  link.velocity.setConstant(unknown);
  link.acceleration.setConstant(unknown);
  link.follows.first.setConstant(3, count, unknown);
  Point point;
  point.position.setConstant(unknown);
  point.velocity.setConstant(unknown);
  point.acceleration.setConstant(unknown);
  point.follows.first.setConstant(2, count, unknown);
  if (plan.values().second_order()) {
    const Eigen::MatrixXd blank = Eigen::MatrixXd::Constant(count, count, unknown);
    link.follows.second.assign(3, blank);
    point.follows.second.assign(2, blank);
  }
  Configuration configuration;
  configuration.links.assign(plan.mechanism().links().size(), link);
  configuration.outputs.assign(plan.mechanism().outputs().size(), point);
  configuration.regularity = Status::near_singular;
  configuration.residual = unknown;
  return configuration;
}

std::optional<EventLocation> locate_fold(SnapshotSolver& solver, const ConfigurationPair& near,
                                         bool through) {
  // Narrower where the branches bend sharply, as they do beside another fold, at the cost of some
  // rounding; wider where rounding leaves nothing else.
  constexpr std::array usual{1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6, 1e-2, 6e-2};
  constexpr std::array wide{6e-2, 2e-2, 6e-3, 2e-3, 6e-4, 2e-4, 6e-5};
  constexpr double settled = 1e-10;
  constexpr double lessened = 0.1;  // What lessens by chance is rounding.
  std::optional<FoldEstimate> best;
  for (const double target : through ? std::span<const double>(wide) : usual) {
    const auto found = fold_at_separation(solver, near, target);
    if (found && !(best && best->change * lessened <= found->change)) {
      best = found;
    }
    if (best && best->change < settled) {
      break;
    }
  }
  return best ? std::optional(best->location) : std::nullopt;
}

namespace {

/// One width of a crossing's interpolation, and the weights that led to it.
struct CrossingEstimate {
  double parameter;
  Configuration configuration;
  Eigen::VectorXd place;
};

/// Two branches about their crossing, as straight lines.
struct CrossingLines {
  double centre;
  Eigen::VectorXd one, other;              ///< at the centre
  Eigen::VectorXd one_slope, other_slope;  ///< across the interval
  Eigen::VectorXd along;                   ///< direction in which their difference changes
};

std::optional<CrossingEstimate> crossing_at_width(SnapshotSolver& solver,
                                                  const CrossingLines& lines, double width) {
  constexpr int half = 3;
  Eigen::VectorXd nodes(2 * half);
  std::array<ConfigurationPair, std::size_t{2} * half> found{};
  for (int index = 0; index < 2 * half; ++index) {
    const int place = index < half ? index - half : index - half + 1;
    const double parameter = lines.centre + width * place / half;
    if (!solver.covers(parameter)) {
      return std::nullopt;
    }
    const double move = parameter - lines.centre;
    const double apart = ((lines.other_slope - lines.one_slope) * move).norm();
    const auto pair = pair_near(solver.at(parameter), lines.one + lines.one_slope * move,
                                lines.other + lines.other_slope * move, 0.3 * apart);
    if (!pair) {
      return std::nullopt;
    }
    nodes(index) = lines.along.dot(pair->apart());
    found[static_cast<std::size_t>(index)] = *pair;
  }
  const Eigen::VectorXd weights = weights_at_zero(nodes);
  CrossingEstimate estimate{lines.centre, {}, Eigen::VectorXd::Zero(lines.one.size())};
  Blend blend(solver.plan());
  for (int index = 0; index < 2 * half; ++index) {
    const ConfigurationPair& pair = found[static_cast<std::size_t>(index)];
    estimate.parameter += weights(index) * (pair.set->parameter - lines.centre);
    estimate.place += weights(index) / 2 * (pair.first().at + pair.second().at);
    blend.add(pair.set->configuration(pair.one), weights(index) / 2);
    blend.add(pair.set->configuration(pair.other), weights(index) / 2);
  }
  estimate.configuration = blend.result();
  return estimate;
}

}  // namespace

std::optional<EventLocation> locate_crossing(SnapshotSolver& solver, const ConfigurationPair& left,
                                             const ConfigurationPair& right) {
  const double step = right.set->parameter - left.set->parameter;
  CrossingLines lines;
  lines.one_slope = (right.first().at - left.first().at) / step;
  lines.other_slope = (right.second().at - left.second().at) / step;
  lines.along = (right.apart() - left.apart()).normalized();
  const double before = lines.along.dot(left.apart());
  const double after = lines.along.dot(right.apart());
  const double move = -before / (after - before) * step;
  lines.centre = left.set->parameter + move;
  lines.one = left.first().at + lines.one_slope * move;
  lines.other = left.second().at + lines.other_slope * move;

  std::optional<CrossingEstimate> best;
  std::optional<CrossingEstimate> last;
  double least = std::numeric_limits<double>::infinity();
  constexpr int widths = 16;
  double width = step;
  for (int index = 0; index < widths; ++index, width *= 2) {
    const auto estimate = crossing_at_width(solver, lines, width);
    if (!estimate) {
      if (last) {
        break;
      }
      continue;  // So close to one another the branches cannot be told apart.
    }
    if (last) {
      const double change =
          (estimate->place - last->place).norm() +
          std::abs(estimate->parameter - last->parameter) * (after - before) / std::abs(step);
      if (change < least) {
        least = change;
        best = estimate;
      }
    }
    last = estimate;
  }
  const std::optional<CrossingEstimate>& chosen = best ? best : last;
  if (!chosen) {
    return std::nullopt;
  }
  return EventLocation{chosen->parameter, chosen->configuration};
}

double distance_to_escape(const ConfigurationPoint& point) {
  const Eigen::VectorXd outward = point.at.normalized();
  return outward.dot(point.at) / outward.dot(point.slope);
}

std::optional<EventLocation> locate_escape(SnapshotSolver& solver, const SnapshotPointer& near,
                                           PointIndex index) {
  constexpr int most = 12;
  SnapshotPointer set = near;
  double parameter = near->parameter;
  for (int iteration = 0; iteration < most; ++iteration) {
    const ConfigurationPoint& point = set->points[index];
    const double distance = distance_to_escape(point);
    parameter = set->parameter + distance;
    const SnapshotPointer next = solver.at(set->parameter + distance * 15 / 16);
    const Eigen::VectorXd predicted = 16 * point.at;
    const PointIndex followed = nearest(*next, predicted);
    if (!next->separable || !followed.exists() ||
        !((next->points[followed].at - predicted).norm() < 0.3 * predicted.norm())) {
      break;
    }
    set = next;
    index = followed;
  }
  return EventLocation{parameter, unknown_configuration(solver.plan())};
}

}  // namespace assur::mechanism::follow
