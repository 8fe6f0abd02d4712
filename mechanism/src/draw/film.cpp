#include "draw/film.hpp"

#include <algorithm>
#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/sweep.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "draw/symbols.hpp"
#include "draw/ways.hpp"

namespace assur::mechanism::draw {

namespace {

/// An animation of fewer steps is not smooth; more steps make no visible difference.
constexpr int fewest_steps = 180;
constexpr int most_steps = 720;
constexpr int output_numbers = 6;
constexpr int spread_numbers = 3;
/// With more parameters no derivatives are taken, since a picture would take too long.
constexpr std::size_t most_derived = 200;

/// A configuration at a step.
struct Row {
  int step;
  LinkPoses poses;
  std::vector<double> outputs, spreads;
};

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
  /// `varied` is the request with its covariance, which takes no part in solving: an ellipse needs
  /// no second derivatives.
  FilmMaker(const Mechanism& mechanism, const Request& request, const Request& varied, int chosen)
      : mechanism_(mechanism),
        request_(request),
        plan_(mechanism, request),
        varied_(Plan(mechanism, varied).values()),
        asked_for_(chosen) {
    film_.chosen = std::max(chosen, 1);
  }

  Film made(std::size_t most_numbers) {
    if (!request_.sweep) {
      record_configurations();
      return finished();
    }
    const Values values = plan_.values();
    film_.from = values.value_of(request_.sweep->from);
    film_.to = values.value_of(request_.sweep->to);
    const int own = request_.sweep->count - 1;
    const int fine = own == 0 || own >= fewest_steps ? own : own * ((fewest_steps - 1) / own + 1);
    film_.count = std::min(fine, most_steps) + 1;
    while (true) {
      record_sweep();
      Film film = finished();
      const std::size_t numbers = numbers_of(film);
      if (numbers <= most_numbers || film_.count <= 2) {
        return film;
      }
      const double part = static_cast<double>(most_numbers) / static_cast<double>(numbers);
      film_.count = std::max(static_cast<int>(part * (film_.count - 1)), 1) + 1;
    }
  }

 private:
  static std::size_t numbers_of(const Film& film) {
    std::size_t numbers = 0;
    for (const FilmedBranch& branch : film.branches) {
      numbers += branch.points.size() + branch.outputs.size() + branch.spreads.size();
    }
    return numbers;
  }

  void record_configurations() {
    const Solution solution = plan_.solve(plan_.values());
    int number = 0;
    for (const Configuration& configuration : solution.configurations) {
      record(++number, 0, configuration);
    }
    if (asked_for_ == 0 && !plan_.request().reference.empty() && number > 0) {
      film_.chosen = static_cast<int>(plan_.nearest(plan_.values(), solution)->configuration) + 1;
    }
  }

  void record_sweep() {
    rows_.clear();
    reaches_.clear();
    film_.events.clear();
    Request request = request_;
    request.sweep->count = film_.count;
    const Plan plan(mechanism_, request);
    if (asked_for_ == 0 && !request_.reference.empty()) {
      film_.chosen = nearest_branch(mechanism_, request).value_or(1);
    }
    (void)sweep(plan, {[&](const SweepRecord& row) {
                         if (row.event.empty()) {
                           vary_at(row.parameter);
                           record(row.branch, row.step, *row.state);
                         } else {
                           const auto [kind, branches] = parts_of_event(row.event);
                           film_.events.push_back({kind, branches, row.parameter});
                         }
                       },
                       nullptr, nullptr});
  }

  void vary_at(double parameter) {
    if (request_.want.sensitivity && varied_at_ != parameter) {
      varied_.set(request_.sweep->parameter, parameter);
      varied_at_ = parameter;
    }
  }

  void record(int branch, int step, const Configuration& configuration) {
    Row row{step, link_poses(mechanism_, plan_.mechanism(), configuration), {}, {}};
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    const double rates = configuration.rates_known ? 1 : unknown;
    for (const Point& point : configuration.outputs) {
      const Eigen::Vector2d velocity = request_.want.velocity
                                           ? Eigen::Vector2d(rates * point.velocity)
                                           : Eigen::Vector2d::Constant(unknown);
      const Eigen::Vector2d acceleration = request_.want.acceleration
                                               ? Eigen::Vector2d(rates * point.acceleration)
                                               : Eigen::Vector2d::Constant(unknown);
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
    auto [reaches, is_new] = reaches_.try_emplace(branch, mechanism_.joints().size());
    include_displacements(mechanism_, plan_.mechanism(), configuration, reaches->second);
    rows_[branch].push_back(std::move(row));
  }

  /// The film of what was recorded; the features of each step are evaluated once.
  Film finished() {
    if (rows_.empty()) {
      const Values values = plan_.values();
      throw MechanismError("", "there is nothing to draw: no-assembly" +
                                   std::string(request_.sweep ? " at any step of the sweep" : "") +
                                   ": " + plan_.obstacle(values));
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
      film.chosen = rows_.begin()->first;
    }
    const Row& first = rows_[film.chosen].front();
    const FeatureFrames& first_frames = frames[static_cast<std::size_t>(first.step)];
    const double size = size_of(mechanism_, first_frames, first.poses);
    Symbols symbols =
        symbols_of({mechanism_, first_frames, first.poses, reaches_.at(film.chosen), size});
    film.shapes = std::move(symbols.shapes);
    film.points = symbols.points.size();
    for (const auto& [number, rows] : rows_) {
      const std::size_t kept_free = number < film.chosen ? 1 : 0;
      if (number == film.chosen || film.branches.size() + kept_free < most_drawn) {
        film.branches.push_back(branch_of(number, rows, symbols.points, frames, size));
      }
    }
    film.left_out = rows_.size() - film.branches.size();
    return film;
  }

  [[nodiscard]] FilmedBranch branch_of(int number, const std::vector<Row>& rows,
                                       const std::vector<Anchor>& points,
                                       const std::vector<FeatureFrames>& frames,
                                       double size) const {
    const auto steps = static_cast<std::size_t>(film_.count);
    const std::size_t outputs = output_numbers * plan_.mechanism().outputs().size();
    const std::size_t spreads =
        request_.want.sensitivity ? spread_numbers * plan_.mechanism().outputs().size() : 0;
    const double absent = std::numeric_limits<double>::quiet_NaN();
    FilmedBranch branch{number, std::vector<double>(2 * steps * points.size(), absent),
                        std::vector<double>(steps * outputs, absent),
                        std::vector<double>(steps * spreads, absent)};
    for (const Row& row : rows) {
      const auto step = static_cast<std::size_t>(row.step);
      for (std::size_t point = 0; point < points.size(); ++point) {
        const Eigen::Vector2d at =
            position(points[point], mechanism_, frames[step], row.poses, reaches_.at(number), size);
        branch.points[2 * (step * points.size() + point)] = at.x();
        branch.points[2 * (step * points.size() + point) + 1] = at.y();
      }
      std::copy(row.outputs.begin(), row.outputs.end(),
                branch.outputs.begin() + static_cast<std::ptrdiff_t>(step * outputs));
      std::copy(row.spreads.begin(), row.spreads.end(),
                branch.spreads.begin() + static_cast<std::ptrdiff_t>(step * spreads));
    }
    return branch;
  }

  const Mechanism& mechanism_;
  const Request& request_;
  Plan plan_;
  Values varied_;
  std::optional<double> varied_at_;  ///< the value of the swept parameter there
  int asked_for_;                    ///< the branch that is to be looked at; 0 where none is named
  Film film_;
  std::map<int, std::vector<Row>> rows_;
  std::map<int, Reaches> reaches_;
};

}  // namespace

Film film_of(const Mechanism& mechanism, const Request& request, std::size_t most_numbers,
             int chosen) {
  Request shown = request;
  shown.want.sensitivity = varies(mechanism, request);
  shown.covariance.reset();
  return FilmMaker(mechanism, shown, shown.want.sensitivity ? request : shown, chosen)
      .made(most_numbers);
}

}  // namespace assur::mechanism::draw
