#include "lone_branches.hpp"

#include <algorithm>
#include <cmath>

#include "event_location.hpp"

namespace assur::mechanism::follow {

namespace {

/// How far a branch may be from where its slope led, in parts of one plus the size of the point.
constexpr double longest_miss = 0.01;
/// The miss may be at most this small a part of the distance to any other point: one part in five.
constexpr double clear_of_others = 5;

/// Whether one point leads to another, and to no third point beside that. A miss that all of them
/// share does not count, since it does not confuse them.
bool leads(const BranchPoint& from, const BranchPoint& to, const Eigen::VectorXd& curvature) {
  const double step = to.set->parameter - from.set->parameter;
  const Eigen::VectorXd miss =
      from.here().at + step * from.here().slope + step * step / 2 * curvature - to.here().at;
  return miss.norm() <= longest_miss * (1 + from.here().at.norm()) &&
         std::ranges::all_of(to.set->points, [&](const ConfigurationPoint& other) {
           const Eigen::VectorXd apart = other.at - to.here().at;
           return &other == &to.here() ||
                  apart.squaredNorm() > clear_of_others * std::abs(miss.dot(apart));
         });
}

/// The second derivative, at the second of two points, of the cubic through both.
Eigen::VectorXd curvature_at(const ConfigurationPoint& before, const ConfigurationPoint& here,
                             double step) {
  return (2 * before.slope + 4 * here.slope - 6 / step * (here.at - before.at)) / step;
}

}  // namespace

bool BranchPoint::is_known() const { return state().path_known && here().slope.allFinite(); }

SnapshotPointer LoneBranches::at(double parameter) {
  SnapshotPointer& set = kept_[parameter];
  if (set == nullptr) {
    set = solver_.at(parameter);
  }
  return set;
}

std::optional<BranchPoint> LoneBranches::continued(BranchPoint from, double parameter) {
  constexpr int most_tries = 400;
  constexpr double shorter = 0.6;
  constexpr double longer = 16;  // A long step may pass a place at which a short one would end.
  constexpr double least_part = 1.0 / 64;  // of the last step
  double step = parameter - from.set->parameter;
  double last = std::abs(step);
  Eigen::VectorXd curvature = Eigen::VectorXd::Zero(from.here().at.size());
  for (int attempt = 0; attempt < most_tries && from.set->parameter != parameter &&
                        std::abs(step) > least_part * last;
       ++attempt) {
    const double rest = parameter - from.set->parameter;
    const bool arrives = std::abs(step) >= std::abs(rest);
    step = arrives ? rest : step;
    const double next = from.set->parameter + step;
    const SnapshotPointer set = arrives ? at(parameter) : solver_.at(next);
    const Eigen::VectorXd place =
        from.here().at + step * from.here().slope + step * step / 2 * curvature;
    const BranchPoint to{set, nearest(*set, place)};
    const bool is_led_to = to.point.exists() && leads(from, to, curvature);
    if (is_led_to && arrives && !to.is_known()) {
      return std::nullopt;
    }
    if (is_led_to && to.is_known() && leads(to, from, curvature)) {
      curvature = curvature_at(from.here(), to.here(), step);
      from = to;
      last = std::abs(step);
      step *= longer;
    } else {
      step *= shorter;
    }
  }
  return from.set->parameter == parameter ? std::optional(from) : std::nullopt;
}

}  // namespace assur::mechanism::follow
