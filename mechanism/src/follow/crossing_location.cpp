#include "crossing_location.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "branch_matching.hpp"

namespace assur::mechanism::follow {

namespace {

/// Branches near their crossing, as the tangents there of the cubics through both sides.
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
  /// The least distance of a line from the others, at unit parameter distance from the centre.
  [[nodiscard]] double clearance(std::size_t index) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t other = 0; other < count(); ++other) {
      least = other == index ? least : std::min(least, (slopes[other] - slopes[index]).norm());
    }
    return least;
  }
  /// The configurations nearest to the lines, if each is near its own line only.
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
  /// The distance to which the branches have spread, with the sign of the side.
  [[nodiscard]] double spread_of(const ConfigurationBundle& bundle) const {
    const Eigen::VectorXd middle = bundle.middle();
    double sum = 0;
    for (std::size_t index = 0; index < count(); ++index) {
      sum += spreading[index].dot(bundle.at(index).at - middle);
    }
    return sum;
  }
};

/// The places of a crossing's samples, relative to the width. The outer four predict the inner two
/// of a smooth branch.
constexpr std::array crossing_places{-1.0, -2.0 / 3, 2.0 / 3, 1.0, -1.0 / 3, 1.0 / 3};
constexpr std::size_t outer_places = 4;
using CrossingSamples = std::array<ConfigurationBundle, crossing_places.size()>;

/// The place of a branch that goes through its crossing smoothly, from values and derivatives at
/// the outer places.
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

/// An estimate from one width of a crossing's interpolation.
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

}  // namespace

Eigen::VectorXd ConfigurationBundle::middle() const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(at(0).at.size());
  for (std::size_t index = 0; index < count(); ++index) {
    sum += at(index).at;
  }
  return sum / static_cast<double>(count());
}

bool is_one(const Snapshot& set, const Eigen::VectorXd& place) {
  constexpr double close = 1e-5;
  const auto count = std::ranges::count_if(set.points, [&](const ConfigurationPoint& point) {
    return (point.at - place).norm() < close;
  });
  return count == 1 || set.solution.status == SolutionStatus::degenerate;
}

std::optional<EventLocation> locate_crossing(SnapshotSolver& solver,
                                             const ConfigurationBundle& left,
                                             const ConfigurationBundle& right) {
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
  int in_vain = 0;  // the number of widths that have not improved the estimate
  double width = (right.set->parameter - left.set->parameter) / 1024;
  for (int index = 0; index < widths && in_vain < most_in_vain; ++index, width *= 2) {
    in_vain += last ? 1 : 0;
    const auto estimate = crossing_at_width(solver, lines, width);
    if (!estimate) {
      continue;  // At this width the branches are too close, or too far apart, to be followed.
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
        in_vain = opening < crossing_limit ? 0 : in_vain;
        least = error;
        best = estimate;
      }
    }
    last = estimate;
  }
  // Rounding of a length opens a crossing of steep branches further.
  const double steepness = std::max(1.0, fastest / slowest);
  if (!best || !(opening < steepness * crossing_limit) ||
      !is_one(*solver.at(best->parameter), best->place)) {
    return std::nullopt;
  }
  return EventLocation{best->parameter, best->configuration,
                       least + rounding * (1 / fastest + std::abs(best->parameter))};
}

}  // namespace assur::mechanism::follow
