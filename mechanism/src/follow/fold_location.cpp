#include "fold_location.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace assur::mechanism::follow {

namespace {

/// The same pair at another distance from its fold. Its separation is proportional to the square
/// root of the distance.
std::optional<ConfigurationPair> followed(SnapshotSolver& solver, const ConfigurationPair& pair,
                                          double parameter) {
  const double distance = pair.distance_to_fold();
  const double move = parameter - pair.set->parameter;
  return pair_followed(solver, pair, parameter, std::sqrt((distance - move) / distance));
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

/// The estimate from one width of a fold's interpolation, and the contribution of its widest pair,
/// which is about the change that the next narrower width would cause.
struct FoldEstimate {
  EventLocation location;
  double change;
};

/// How g is computed at a configuration. The configuration's own g is exact for the rounded
/// lengths, and so is the place along the motion. The pair's g, with opposite signs, is free of the
/// motion of the middle, which spoils the interpolation of pairs far from their fold.
enum class NodeOf : unsigned char { each, pair };

/// Interpolates over pairs up to a separation s; the truncation error is of order s^8.
std::optional<FoldEstimate> fold_at_separation(SnapshotSolver& solver,
                                               const ConfigurationPair& near, double target,
                                               NodeOf node) {
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
    const double first = along.dot(pair.first().slope);
    const double second = along.dot(pair.second().slope);
    const double middle = node == NodeOf::pair ? (first + second) / 2 : 0;
    nodes(2 * index) = 1 / (first - middle);
    nodes(2 * index + 1) = 1 / (second - middle);
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

std::optional<ConfigurationPair> pair_followed(SnapshotSolver& solver,
                                               const ConfigurationPair& pair, double parameter,
                                               double shrink) {
  if (!(shrink > 0)) {
    return std::nullopt;
  }
  const Eigen::VectorXd middle =
      (pair.first().at + pair.second().at) / 2 +
      (pair.first().slope + pair.second().slope) / 2 * (parameter - pair.set->parameter);
  const Eigen::VectorXd half = pair.apart() / 2 * shrink;
  constexpr double tolerance = 0.3;
  return pair_near(solver.at(parameter), middle - half, middle + half,
                   tolerance * pair.separation() * shrink);
}

std::optional<EventLocation> locate_fold(SnapshotSolver& solver, const ConfigurationPair& near,
                                         bool through) {
  // The narrow widths serve branches that bend sharply, as beside another fold, at the cost of some
  // rounding; the wide ones come last, for cases in which rounding spoils all others.
  constexpr std::array usual{1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6, 3e-7, 1e-2, 6e-2};
  constexpr std::array wide{6e-2, 2e-2, 6e-3, 2e-3, 6e-4, 2e-4, 6e-5};
  constexpr double settled = 1e-10;
  constexpr double lessened = 0.1;  // A smaller improvement may be accidental rounding.
  std::optional<FoldEstimate> best;
  for (const double target : through ? std::span<const double>(wide) : usual) {
    const auto found = fold_at_separation(solver, near, target, NodeOf::each);
    if (found && !(best && best->change * lessened <= found->change)) {
      best = found;
    }
    if (best && best->change < settled) {
      break;
    }
  }
  return best ? std::optional(best->location) : std::nullopt;
}

std::optional<EventLocation> locate_fold_from(SnapshotSolver& solver,
                                              const ConfigurationPair& near) {
  for (const double part : {1.25, 1.6, 2.0, 2.5, 3.1, 4.0}) {
    const auto found = fold_at_separation(solver, near, part * near.separation(), NodeOf::pair);
    if (found) {
      return found->location;
    }
  }
  return std::nullopt;
}

}  // namespace assur::mechanism::follow
