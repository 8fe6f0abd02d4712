#include "event_location.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "branch_matching.hpp"

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
  const double uncertainty =
      std::abs(change_of_shift) + 16 * std::numeric_limits<double>::epsilon() * std::abs(estimate);
  const double change = change_of_place.norm() + std::abs(change_of_shift / widest) * target;
  if (!(std::abs(shift) < 0.1 * std::abs(widest) && change < 0.01 * target)) {
    return std::nullopt;
  }
  return FoldEstimate{{estimate + shift, blend.result(), uncertainty}, change};
}

}  // namespace

const ConfigurationPoint& ConfigurationPair::first() const { return set->points[one]; }
const ConfigurationPoint& ConfigurationPair::second() const { return set->points[other]; }

double ConfigurationPair::distance_to_fold() const {
  const Eigen::VectorXd difference = apart();
  return -difference.squaredNorm() / (2 * difference.dot(second().slope - first().slope));
}

Eigen::VectorXd ConfigurationBundle::middle() const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(at(0).at.size());
  for (std::size_t index = 0; index < count(); ++index) {
    sum += at(index).at;
  }
  return sum / static_cast<double>(count());
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
  constexpr std::array usual{1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6, 3e-7, 1e-2, 6e-2};
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

/// Branches about their crossing, as straight lines that touch cubics.
struct CrossingLines {
  double centre;
  std::vector<Eigen::VectorXd> places;     ///< at the centre
  std::vector<Eigen::VectorXd> slopes;     ///< there
  std::vector<Eigen::VectorXd> spreading;  ///< directions from the middle, of length one together

  CrossingLines(const ConfigurationBundle& left, const ConfigurationBundle& right) {
    const double step = right.set->parameter - left.set->parameter;
    const Eigen::VectorXd before = left.middle();
    const Eigen::VectorXd after = right.middle();
    double meets = 0;
    double spread = 0;
    for (std::size_t index = 0; index < left.count(); ++index) {
      const Eigen::VectorXd offset = left.at(index).at - before;
      spreading.emplace_back(right.at(index).at - after - offset);
      meets -= spreading.back().dot(offset);
      spread += spreading.back().squaredNorm();
    }
    const double move = meets / spread * step;
    centre = left.set->parameter + move;
    for (std::size_t index = 0; index < left.count(); ++index) {
      const auto at = [&](double part) {
        return cubic(left.at(index), right.at(index), step, part);
      };
      constexpr double nearby = 1e-3;
      const double part = move / step;
      slopes.emplace_back((at(part + nearby) - at(part - nearby)) / (2 * nearby * step));
      places.emplace_back(at(part));
      spreading[index] /= std::sqrt(spread);
    }
  }

  [[nodiscard]] std::size_t count() const { return places.size(); }
  [[nodiscard]] Eigen::VectorXd place(std::size_t index, double move) const {
    return places[index] + slopes[index] * move;
  }
  /// Least distance of a line from the others, at a distance of one from the centre.
  [[nodiscard]] double clearance(std::size_t index) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t other = 0; other < count(); ++other) {
      least = other == index ? least : std::min(least, (slopes[other] - slopes[index]).norm());
    }
    return least;
  }
  /// The configurations that are nearest to the lines, if each is near its own alone.
  [[nodiscard]] std::optional<ConfigurationBundle> followed(SnapshotSolver& solver,
                                                            double move) const {
    constexpr double tolerance = 0.3;
    ConfigurationBundle bundle{solver.at(centre + move), {}};
    for (std::size_t index = 0; index < count(); ++index) {
      const Eigen::VectorXd expected = place(index, move);
      const PointIndex point = nearest(*bundle.set, expected);
      if (!point.exists() || !((bundle.set->points[point].at - expected).norm() <
                               tolerance * clearance(index) * std::abs(move))) {
        return std::nullopt;
      }
      bundle.points.push_back(point);
    }
    return bundle;
  }
  /// How far the branches have spread from one another, with the sign of the side.
  [[nodiscard]] double spread_of(const ConfigurationBundle& bundle) const {
    const Eigen::VectorXd middle = bundle.middle();
    double sum = 0;
    for (std::size_t index = 0; index < count(); ++index) {
      sum += spreading[index].dot(bundle.at(index).at - middle);
    }
    return sum;
  }
};

/// The places of a crossing's samples, in parts of the width. The outer ones tell where a smooth
/// branch is at the inner ones.
constexpr std::array crossing_places{-1.0, -2.0 / 3, 2.0 / 3, 1.0, -1.0 / 3, 1.0 / 3};
constexpr std::size_t outer_places = 4;
using CrossingSamples = std::array<ConfigurationBundle, crossing_places.size()>;

/// Where a branch that is smooth from one side of its crossing to the other would be, by values and
/// derivatives at the outer places.
Eigen::VectorXd smooth_place(const CrossingSamples& samples, std::size_t branch, double width,
                             double place) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(samples[0].at(branch).at.size());
  for (std::size_t one = 0; one < outer_places; ++one) {
    double basis = 1;
    double slope = 0;
    for (std::size_t other = 0; other < outer_places; ++other) {
      if (other != one) {
        const double apart = crossing_places[one] - crossing_places[other];
        basis *= (place - crossing_places[other]) / apart;
        slope += 1 / apart;
      }
    }
    const double away = place - crossing_places[one];
    const ConfigurationPoint& point = samples[one].at(branch);
    sum += basis * basis * ((1 - 2 * slope * away) * point.at + width * away * point.slope);
  }
  return sum;
}

/// One width of a crossing's interpolation, and the place that led to it.
struct CrossingEstimate {
  double parameter;
  Configuration configuration;
  Eigen::VectorXd place;
  double opening;
};

std::optional<CrossingEstimate> crossing_at_width(SnapshotSolver& solver,
                                                  const CrossingLines& lines, double width) {
  CrossingSamples samples;
  Eigen::VectorXd nodes(static_cast<Eigen::Index>(samples.size()));
  for (std::size_t index = 0; index < samples.size(); ++index) {
    const auto found = lines.followed(solver, width * crossing_places[index]);
    if (!found) {
      return std::nullopt;
    }
    samples[index] = *found;
    nodes(static_cast<Eigen::Index>(index)) = lines.spread_of(*found);
  }
  const Eigen::VectorXd weights = weights_at_zero(nodes);
  CrossingEstimate estimate{lines.centre, {}, Eigen::VectorXd::Zero(lines.places[0].size()), 0};
  Blend blend(solver.plan());
  for (std::size_t index = 0; index < samples.size(); ++index) {
    const double weight = weights(static_cast<Eigen::Index>(index));
    const ConfigurationBundle& bundle = samples[index];
    estimate.parameter += weight * (bundle.set->parameter - lines.centre);
    estimate.place += weight * bundle.middle();
    for (const PointIndex point : bundle.points) {
      blend.add(bundle.set->configuration(point), weight / static_cast<double>(bundle.count()));
    }
  }
  for (std::size_t branch = 0; branch < lines.count(); ++branch) {
    for (std::size_t inner = outer_places; inner < samples.size(); ++inner) {
      const double miss = (samples[inner].at(branch).at -
                           smooth_place(samples, branch, width, crossing_places[inner]))
                              .norm();
      estimate.opening =
          std::max(estimate.opening, miss * lines.clearance(branch) * std::abs(width));
    }
  }
  estimate.configuration = blend.result();
  return estimate;
}

/// Whether one configuration stands at a place, and not two to either side of it, or none: its
/// closures tell an opening that is lost in the rounding of the branches.
bool is_one(const Snapshot& set, const Eigen::VectorXd& place) {
  constexpr double close = 1e-5;
  const auto count = std::ranges::count_if(set.points, [&](const ConfigurationPoint& point) {
    return (point.at - place).norm() < close;
  });
  return count == 1 || set.solution.status == SolutionStatus::degenerate;
}

}  // namespace

std::optional<EventLocation> locate_crossing(SnapshotSolver& solver,
                                             const ConfigurationBundle& left,
                                             const ConfigurationBundle& right, double limit) {
  const CrossingLines lines(left, right);
  double fastest = 0;
  double slowest = std::numeric_limits<double>::infinity();
  for (const Eigen::VectorXd& slope : lines.slopes) {
    fastest = std::max(fastest, (slope - lines.slopes[0]).norm());
    slowest = std::min(slowest, slope.norm());
  }
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  constexpr int widths = 34;
  constexpr int most_in_vain = 6;
  std::optional<CrossingEstimate> best;
  std::optional<CrossingEstimate> last;
  double least = std::numeric_limits<double>::infinity();
  double opening = least;
  int in_vain = 0;  // widths since anything became better
  double width = (right.set->parameter - left.set->parameter) / 1024;
  for (int index = 0; index < widths && in_vain < most_in_vain; ++index, width *= 2) {
    in_vain += last ? 1 : 0;
    const auto estimate = crossing_at_width(solver, lines, width);
    if (!estimate) {
      continue;  // So close to one another the branches cannot be told apart, or so far.
    }
    if (estimate->opening < opening / 2) {
      in_vain = 0;
    }
    opening = std::min(opening, estimate->opening);
    if (last) {
      // Rounding grows as configurations come closer, and two widths may agree by chance.
      const double spread = fastest * std::abs(width);
      const double error = std::max({(estimate->place - last->place).norm() / fastest,
                                     std::abs(estimate->parameter - last->parameter),
                                     estimate->opening / spread, rounding / (fastest * spread)});
      if (error < least) {
        in_vain = opening < limit ? 0 : in_vain;
        least = error;
        best = estimate;
      }
    }
    last = estimate;
  }
  // A length that rounding has changed opens branches that cross steeply by more.
  const double steepness = std::max(1.0, fastest / slowest);
  if (!best || !(opening < steepness * limit) ||
      !is_one(*solver.at(best->parameter), best->place)) {
    return std::nullopt;
  }
  return EventLocation{best->parameter, best->configuration,
                       least + rounding * (1 / fastest + std::abs(best->parameter))};
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
