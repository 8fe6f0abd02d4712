#include "flat_fold.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace assur::mechanism::follow {

namespace {

/// The same pair at another distance from a flat fold. Its separation is proportional to the fourth
/// root of the distance.
std::optional<ConfigurationPair> followed(SnapshotSolver& solver, const ConfigurationPair& pair,
                                          double fold, double parameter) {
  const double from = fold - pair.set->parameter;
  return pair_followed(solver, pair, parameter, std::pow((fold - parameter) / from, 0.25));
}

/// The location of the fold, if the pair approaches it as the fourth root of the distance: then
/// `distance_to_fold` is twice the distance, and decreases twice as fast as the parameter advances.
std::optional<double> estimate_from(SnapshotSolver& solver, const ConfigurationPair& pair) {
  const double told = pair.distance_to_fold();
  if (!std::isfinite(told)) {
    return std::nullopt;
  }
  const double here = pair.set->parameter;
  const auto next = followed(solver, pair, here + told / 2, here + told / 4);
  if (!next) {
    return std::nullopt;
  }
  constexpr double slack = 0.2;
  const double order = 4 * (told - next->distance_to_fold()) / told;
  return std::abs(order - 2) < slack
             ? std::optional(next->set->parameter + next->distance_to_fold() / order)
             : std::nullopt;
}

}  // namespace

std::optional<EventLocation> locate_flat_fold(SnapshotSolver& solver,
                                              const ConfigurationPair& near) {
  std::optional<double> estimate = estimate_from(solver, near);
  if (!estimate) {
    return std::nullopt;
  }
  // Pairs up to a separation s have a truncation error of order s^8. The rounding error of a pair
  // grows as the inverse third power of its own separation.
  constexpr int pairs = 4;
  constexpr double widest = 1e-2;
  constexpr int most_steps = 8;
  ConfigurationPair start = near;
  for (int step = 0; step < most_steps && start.separation() > 1.5 * widest; ++step) {
    const double part = std::max(1.0 / 256, std::pow(widest / start.separation(), 4));
    const auto next =
        followed(solver, start, *estimate, *estimate - part * (*estimate - start.set->parameter));
    estimate = next ? estimate_from(solver, *next) : std::nullopt;
    if (!estimate) {
      return std::nullopt;
    }
    start = *next;
  }
  const double distance =
      (*estimate - start.set->parameter) * std::pow(widest / start.separation(), 4);
  Eigen::VectorXd squares(pairs);
  std::array<ConfigurationPair, pairs> found{};
  for (int index = 0; index < pairs; ++index) {
    const double part = static_cast<double>(index + 1) / pairs;
    const auto pair = followed(solver, start, *estimate, *estimate - distance * std::pow(part, 4));
    if (!pair) {
      return std::nullopt;
    }
    found[static_cast<std::size_t>(index)] = *pair;
    squares(index) = std::pow(pair->separation(), 2);
  }
  const Eigen::VectorXd weights = weights_at_zero(squares);
  const Eigen::VectorXd fewer = weights_at_zero(squares.head(pairs - 1));
  Blend blend(solver.plan());
  double shift = 0;
  double shift_of_fewer = 0;
  for (int index = 0; index < pairs; ++index) {
    const ConfigurationPair& pair = found[static_cast<std::size_t>(index)];
    const double from = pair.set->parameter - *estimate;
    shift += weights(index) * from;
    shift_of_fewer += index < pairs - 1 ? fewer(index) * from : 0;
    blend.add(pair.set->configuration(pair.one), weights(index) / 2);
    blend.add(pair.set->configuration(pair.other), weights(index) / 2);
  }
  if (!(std::abs(shift) < 0.1 * std::abs(distance))) {
    return std::nullopt;
  }
  const double uncertainty = std::abs(shift - shift_of_fewer) +
                             16 * std::numeric_limits<double>::epsilon() * std::abs(*estimate);
  return EventLocation{*estimate + shift, blend.result(), uncertainty};
}

}  // namespace assur::mechanism::follow
