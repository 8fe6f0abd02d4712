#include "draw/film.hpp"

#include <algorithm>
#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/sweep.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "draw/film_details.hpp"
#include "draw/sweep_traces.hpp"
#include "draw/symbols.hpp"

namespace assur::mechanism::draw {

namespace {

/// The number of steps for a smooth animation; more steps make no visible difference.
constexpr int fewest_steps = 180;
constexpr int most_steps = 720;
/// With more parameters no derivatives are computed, since a picture would take too long.
constexpr std::size_t most_derived = 200;

/// A configuration at a step.
struct Row {
  int step;
  LinkPoses poses;
  std::vector<double> outputs, spreads;
  DetailRow details;
};

/// The numbers of one kind at all steps, from those of the steps at which the branch exists.
template <typename Numbers>
std::vector<double> at_all_steps(const std::vector<Row>& rows, const Numbers& numbers_of,
                                 std::size_t steps) {
  const std::size_t width = numbers_of(rows.front()).size();
  std::vector<double> all(steps * width, std::numeric_limits<double>::quiet_NaN());
  for (const Row& row : rows) {
    const std::vector<double>& numbers = numbers_of(row);
    std::copy(
        numbers.begin(), numbers.end(),
        all.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(row.step) * width));
  }
  return all;
}

bool varies(const Mechanism& mechanism, const Request& request) {
  const auto& parameters = mechanism.parameters();
  return request.want.sensitivity && parameters.size() <= most_derived &&
         (request.covariance ||
          std::any_of(parameters.begin(), parameters.end(),
                      [](const Parameter& one) { return one.tolerance.exists(); }));
}

/// The covariance of a point whose parameters have this spread.
Eigen::Matrix2d covariance_of(const Point& point, const Spread& spread) {
  const auto& first = point.follows.first;
  if (spread.covariance.size() > 0) {
    return first * spread.covariance * first.transpose();
  }
  const Eigen::MatrixXd deviations = first * spread.tolerances.asDiagonal();
  return deviations * deviations.transpose();
}

class FilmMaker {
 public:
  /// `varied` is the request with its covariance, which is not used in solving: an ellipse needs no
  /// second derivatives.
  FilmMaker(const Mechanism& mechanism, const Request& request, const Request& varied,
            const Filming& filming)
      : mechanism_(mechanism),
        request_(request),
        plan_(mechanism, request),
        values_(plan_.values()),
        varied_(Plan(mechanism, varied).values()),
        filming_(filming) {
    film_.chosen = filming.chosen;
    for (const ParameterIndex parameter : mechanism.parameters().keys()) {
      film_.parameters.push_back(values_.parameter(parameter));
    }
    if (filming.details) {
      details_.emplace(plan_);
    }
  }

  Film made() {
    if (!request_.sweep) {
      record_configurations();
      return finished();
    }
    const Values& values = values_;
    film_.from = values.value_of(request_.sweep->from);
    film_.to = values.value_of(request_.sweep->to);
    const int own = request_.sweep->count - 1;
    const int fine = own == 0 || own >= fewest_steps ? own : own * ((fewest_steps - 1) / own + 1);
    film_.count = std::min(fine, most_steps) + 1;
    while (true) {
      record_sweep();
      Film film = finished();
      const std::size_t numbers = numbers_of(film);
      if (numbers <= filming_.most_numbers || film_.count <= 2) {
        return film;
      }
      const double part = static_cast<double>(filming_.most_numbers) / static_cast<double>(numbers);
      film_.count = std::max(static_cast<int>(part * (film_.count - 1)), 1) + 1;
    }
  }

 private:
  static std::size_t numbers_of(const Film& film) {
    std::size_t numbers = 0;
    for (const FilmedBranch& branch : film.branches) {
      numbers += branch.points.size() + branch.outputs.size() + branch.spreads.size() +
                 branch.angles.size() + branch.transmissions.size() + branch.forces.size();
    }
    return numbers;
  }

  void record_configurations() {
    const Solution solution = plan_.solve(plan_.values());
    int number = 0;
    for (const Configuration& configuration : solution.configurations) {
      record(++number, 0, configuration);
    }
    if (!plan_.request().reference.empty() && number > 0) {
      film_.nearest = static_cast<int>(plan_.nearest(plan_.values(), solution)->configuration) + 1;
    }
  }

  void record_sweep() {
    rows_.clear();
    reaches_.clear();
    film_.events.clear();
    Request request = request_;
    request.sweep->count = film_.count;
    const Plan plan(mechanism_, request);
    if (!request_.reference.empty()) {
      film_.nearest = nearest_branch(mechanism_, request);
    }
    (void)sweep(plan, {[&](const SweepRecord& row) {
                         if (row.event.empty()) {
                           stand_at(row.parameter);
                           record(row.branch, row.step, *row.state);
                         } else {
                           const auto [kind, branches] = parts_of_event(row.event);
                           film_.events.push_back({kind, branches, row.parameter});
                         }
                       },
                       nullptr, nullptr, [&](const Circuits& circuits) { circuits_ = circuits; }});
  }

  /// Sets the swept parameter, if numbers of a step depend on it.
  void stand_at(double parameter) {
    if (stands_at_ == parameter) {
      return;
    }
    stands_at_ = parameter;
    if (details_) {
      values_.set(request_.sweep->parameter, parameter);
    }
    if (request_.want.sensitivity) {
      varied_.set(request_.sweep->parameter, parameter);
    }
  }

  void record(int branch, int step, const Configuration& configuration) {
    Row row{step, link_poses(mechanism_, plan_.mechanism(), configuration), {}, {}, {}};
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    for (const Point& point : configuration.outputs) {
      const Eigen::Vector2d velocity =
          request_.want.velocity ? point.velocity : Eigen::Vector2d::Constant(unknown);
      const Eigen::Vector2d acceleration =
          request_.want.acceleration ? point.acceleration : Eigen::Vector2d::Constant(unknown);
      for (const Eigen::Vector2d& part : {point.position, velocity, acceleration}) {
        row.outputs.insert(row.outputs.end(), {part.x(), part.y()});
      }
      if (request_.want.sensitivity) {
        const Eigen::Matrix2d covariance = covariance_of(point, varied_.spread());
        for (const double part : {covariance(0, 0), covariance(0, 1), covariance(1, 1)}) {
          row.spreads.push_back(configuration.derivatives_known ? part : unknown);
        }
      }
    }
    if (details_) {
      row.details = details_->row_of(values_, configuration);
    }
    auto [reaches, is_new] = reaches_.try_emplace(branch, mechanism_.joints().size());
    include_displacements(mechanism_, plan_.mechanism(), configuration, reaches->second);
    rows_[branch].push_back(std::move(row));
  }

  /// The film of the recorded configurations; the features of each step are evaluated once.
  Film finished() {
    if (rows_.empty()) {
      const Values values = plan_.values();
      throw MechanismError("", "there is nothing to draw: no-assembly" +
                                   std::string(request_.sweep ? " at any step of the sweep" : "") +
                                   ": " + plan_.obstacle(values));
    }
    if (filming_.chosen == 0) {
      film_.chosen = film_.nearest.value_or(1);
    }
    if (details_) {
      details_->name(film_);
    }
    Film film = film_;
    Values values = plan_.values();
    std::vector<FeatureFrames> frames;
    for (int step = 0; step < film.count; ++step) {
      if (request_.sweep) {
        const double part = film.count == 1 ? 0 : static_cast<double>(step) / (film.count - 1);
        values.set(request_.sweep->parameter, film.from + (film.to - film.from) * part);
      }
      frames.push_back(feature_frames(mechanism_, values));
    }
    if (!rows_.contains(film.chosen)) {
      if (filming_.chosen != 0) {
        throw NoSuchConfiguration(static_cast<std::size_t>(filming_.chosen), rows_.size(),
                                  request_.sweep ? "branch" : "configuration");
      }
      film.chosen = rows_.begin()->first;
    }
    const Row& first = rows_[film.chosen].front();
    const FeatureFrames& first_frames = frames[static_cast<std::size_t>(first.step)];
    const double size = size_of(mechanism_, first_frames, first.poses);
    Symbols symbols =
        symbols_of({mechanism_, first_frames, first.poses, reaches_.at(film.chosen), size});
    film.shapes = std::move(symbols.shapes);
    film.points = symbols.points.size();
    if (filming_.seen) {
      const std::optional<int> nearest = nearest_to_seen(symbols.points, frames, size);
      film.is_followed = nearest.has_value();
      film.chosen = nearest.value_or(film.chosen);
    }
    for (const auto& [number, rows] : rows_) {
      const std::size_t kept_free = number < film.chosen ? 1 : 0;
      if (number == film.chosen || film.branches.size() + kept_free < most_drawn) {
        film.branches.push_back(branch_of(number, rows, symbols.points, frames, size));
      }
    }
    film.left_out = rows_.size() - film.branches.size();
    return film;
  }

  /// The coordinates x and y of each point at a recorded step.
  [[nodiscard]] std::vector<double> places_at(int number, const Row& row,
                                              const std::vector<Anchor>& points,
                                              const std::vector<FeatureFrames>& frames,
                                              double size) const {
    std::vector<double> places;
    places.reserve(2 * points.size());
    for (const Anchor& point : points) {
      const Eigen::Vector2d at =
          position(point, mechanism_, frames[static_cast<std::size_t>(row.step)], row.poses,
                   reaches_.at(number), size);
      places.insert(places.end(), {at.x(), at.y()});
    }
    return places;
  }

  /// The branch whose points, between the two steps beside the given pose, are nearest to it, by
  /// the sum of the squares of their distances; nothing if no branch exists there, or if the pose
  /// has other shapes.
  [[nodiscard]] std::optional<int> nearest_to_seen(const std::vector<Anchor>& points,
                                                   const std::vector<FeatureFrames>& frames,
                                                   double size) const {
    const SeenPose& seen = *filming_.seen;
    if (seen.points.size() != 2 * points.size()) {
      return std::nullopt;
    }
    const double place = std::clamp(seen.part, 0.0, 1.0) * (film_.count - 1);
    const int below = static_cast<int>(std::floor(place));
    const double part = place - below;
    double least = std::numeric_limits<double>::infinity();
    std::optional<int> nearest;
    for (const auto& [number, rows] : rows_) {
      const auto at = std::ranges::find(rows, below, &Row::step);
      const auto next = std::ranges::find(rows, below + (part > 0 ? 1 : 0), &Row::step);
      if (at == rows.end() || next == rows.end()) {
        continue;
      }
      const std::vector<double> here = places_at(number, *at, points, frames, size);
      const std::vector<double> there = places_at(number, *next, points, frames, size);
      double square = 0;
      for (std::size_t column = 0; column < here.size(); ++column) {
        const double shown = here[column] + part * (there[column] - here[column]);
        square += std::pow(shown - seen.points[column], 2);
      }
      if (square < least) {
        least = square;
        nearest = number;
      }
    }
    return nearest;
  }

  [[nodiscard]] FilmedBranch branch_of(int number, const std::vector<Row>& rows,
                                       const std::vector<Anchor>& points,
                                       const std::vector<FeatureFrames>& frames,
                                       double size) const {
    const auto steps = static_cast<std::size_t>(film_.count);
    const auto all = [&](const auto& numbers_of) { return at_all_steps(rows, numbers_of, steps); };
    FilmedBranch branch{
        number,
        std::vector<double>(2 * steps * points.size(), std::numeric_limits<double>::quiet_NaN()),
        all([](const Row& row) -> auto& { return row.outputs; }),
        all([](const Row& row) -> auto& { return row.spreads; }),
        all([](const Row& row) -> auto& { return row.details.angles; }),
        all([](const Row& row) -> auto& { return row.details.transmissions; }),
        all([](const Row& row) -> auto& { return row.details.forces; }),
        circuits_.of(number),
        circuits_.next_of(number)};
    for (const Row& row : rows) {
      const std::vector<double> places = places_at(number, row, points, frames, size);
      std::copy(places.begin(), places.end(),
                branch.points.begin() + static_cast<std::ptrdiff_t>(
                                            static_cast<std::size_t>(row.step) * places.size()));
    }
    return branch;
  }

  const Mechanism& mechanism_;
  const Request& request_;
  Plan plan_;
  Values values_;
  Values varied_;
  std::optional<double> stands_at_;  ///< the value of the swept parameter in both
  const Filming& filming_;
  std::optional<FilmDetails> details_;
  Film film_;
  std::map<int, std::vector<Row>> rows_;
  std::map<int, Reaches> reaches_;
  Circuits circuits_;
};

}  // namespace

Film film_of(const Mechanism& mechanism, const Request& request, const Filming& filming) {
  Request shown = request;
  shown.want.sensitivity = varies(mechanism, request);
  shown.covariance.reset();
  return FilmMaker(mechanism, shown, shown.want.sensitivity ? request : shown, filming).made();
}

}  // namespace assur::mechanism::draw
