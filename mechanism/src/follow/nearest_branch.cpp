// Number of the branch of a sweep that is nearest to the request's reference.
#include <algorithm>
#include <assur/mechanism/sweep.hpp>
#include <cmath>
#include <limits>

#include "solve/reference.hpp"
#include "sweep_range.hpp"

namespace assur::mechanism::follow {

namespace {

/// The squared distance between the links of two configurations, with lengths relative to `size`.
double square_between(const Configuration& one, const Configuration& other, double size) {
  double square = 0;
  for (const LinkIndex link : one.links.keys()) {
    const Pose<double>& a = one.links[link].pose;
    const Pose<double>& b = other.links[link].pose;
    square += (std::pow(a.x - b.x, 2) + std::pow(a.y - b.y, 2)) / (size * size) +
              std::pow(a.direction.cos - b.direction.cos, 2) +
              std::pow(a.direction.sin - b.direction.sin, 2);
  }
  return square;
}

/// The largest coordinate of a link's origin, or 1 if all are zero.
double size_of(const Configuration& configuration) {
  double size = 0;
  for (const Frame& link : configuration.links) {
    size = std::max({size, std::abs(link.pose.x), std::abs(link.pose.y)});
  }
  return size > 0 ? size : 1;
}

/// A configuration at a step of the sweep.
struct Start {
  int step;
  Configuration configuration;
};

class NearestBranchFinder {
 public:
  NearestBranchFinder(const Mechanism& mechanism, const Request& request)
      : mechanism_(mechanism),
        request_(request),
        plan_(mechanism, positions_of(request)),
        values_(plan_.values()),
        from_(values_.value_of(request.sweep->from)),
        to_(values_.value_of(request.sweep->to)),
        own_(values_.parameter(request.sweep->parameter)) {}

  std::optional<int> run() {
    if (plan_.request().reference.empty()) {  // no link of it is reported
      return std::nullopt;
    }
    std::optional<Start> start = request_.drawn ? start_at_drawing() : std::nullopt;
    if (!start) {
      start = first_start();
    }
    if (!start) {
      return std::nullopt;
    }
    // A sweep to the next step has the same branches there as the whole one, with the same numbers;
    // without that step it could not distinguish branches that cross here.
    const int next = std::min(start->step + 1, request_.sweep->count - 1);
    const double size = size_of(start->configuration);
    double least = std::numeric_limits<double>::infinity();
    std::optional<int> found;
    run_sweep(from_, value_at(next), next + 1, [&](const SweepRecord& row) {
      if (row.event.empty() && row.branch > 0 && row.step == start->step) {
        const double square = square_between(*row.state, start->configuration, size);
        if (square < least) {  // At a crossing the first of the branches is followed.
          least = square;
          found = row.branch;
        }
      }
    });
    return found;
  }

 private:
  [[nodiscard]] double value_at(int step) const {
    return value_at_step(from_, to_, step, request_.sweep->count);
  }

  void run_sweep(double from, double to, int count,
                 const std::function<void(const SweepRecord&)>& record) const {
    Mechanism mechanism = mechanism_;
    Request request = positions_of(request_);
    request.sweep->from = mechanism.add_number(from, "sweep.from");
    request.sweep->to = mechanism.add_number(to, "sweep.to");
    request.sweep->count = count;
    (void)sweep(Plan(mechanism, request), {record, nullptr, nullptr});
  }

  /// The configuration nearest to the reference at a value of the swept parameter.
  [[nodiscard]] std::optional<Configuration> nearest_at(double value) {
    values_.set(request_.sweep->parameter, value);
    Solution solution = plan_.solve(values_);
    const std::optional<Nearest> found = plan_.nearest(values_, solution);
    return found ? std::optional(std::move(solution.configurations[found->configuration]))
                 : std::nullopt;
  }

  [[nodiscard]] std::optional<Start> first_start() {
    for (int step = 0; step < request_.sweep->count; ++step) {
      if (std::optional<Configuration> found = nearest_at(value_at(step))) {
        return Start{step, std::move(*found)};
      }
    }
    return std::nullopt;
  }

  /// The drawn configuration at the parameter's own value, followed to a neighbouring step: the
  /// nearer one if it can be reached. Returns nothing if that value is outside the sweep.
  [[nodiscard]] std::optional<Start> start_at_drawing() {
    const int last = request_.sweep->count - 1;
    const double part = from_ == to_ ? 0 : (own_ - from_) / (to_ - from_);
    if (!(part >= 0 && part <= 1) || (from_ == to_ && own_ != from_)) {
      return std::nullopt;
    }
    const std::optional<Configuration> drawn = nearest_at(own_);
    if (!drawn) {
      return std::nullopt;
    }
    const int below = std::min(static_cast<int>(part * last), last);
    const int above = std::min(below + 1, last);
    const bool is_nearer_above = part * last - below > 0.5;
    for (const int step : {is_nearer_above ? above : below, is_nearer_above ? below : above}) {
      if (std::optional<Configuration> there = followed(*drawn, value_at(step))) {
        return Start{step, std::move(*there)};
      }
    }
    return std::nullopt;
  }

  /// The configuration at another value on the branch through a drawn configuration at the own
  /// value; nothing if the branch ends before.
  [[nodiscard]] std::optional<Configuration> followed(const Configuration& drawn, double to) const {
    if (to == own_) {
      return drawn;
    }
    const double size = size_of(drawn);
    double least = std::numeric_limits<double>::infinity();
    int branch = 0;
    std::optional<Configuration> reached;
    run_sweep(own_, to, 2, [&](const SweepRecord& row) {
      if (!row.event.empty()) {
        return;
      }
      const double square = row.step == 0 ? square_between(*row.state, drawn, size) : 0;
      if (row.step == 0 && square < least) {
        least = square;
        branch = row.branch;
      } else if (row.step == 1 && row.branch == branch) {
        reached = *row.state;
      }
    });
    return reached;
  }

  const Mechanism& mechanism_;
  const Request& request_;
  Plan plan_;
  Values values_;
  double from_, to_, own_;
};

}  // namespace

}  // namespace assur::mechanism::follow

namespace assur::mechanism {

std::optional<int> nearest_branch(const Mechanism& mechanism, const Request& request) {
  solve::expect_reference(request);
  if (!request.sweep) {
    throw MechanismError("sweep", "the request has no sweep");
  }
  return follow::NearestBranchFinder(mechanism, request).run();
}

}  // namespace assur::mechanism
