#include "snapshot_solver.hpp"

#include <algorithm>
#include <assur/mechanism/sweep.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "plan/driver_laws.hpp"
#include "solve/along_parameter.hpp"
#include "solve/longest_on_links.hpp"
#include "solve/moved_by_parameter.hpp"
#include "solve/precision.hpp"
#include "sweep_range.hpp"

namespace assur::mechanism::follow {

namespace {

/// The largest number of sets between two steps. One turn of a crank takes about a hundred, and the
/// hardest sweeps of the tests take two thousand. A sweep that needs more is refused, because it
/// would take too long.
constexpr int most_between_steps = 10000;
/// The least number of values of a sweep at which the whole turns of angles that laws read are
/// counted.
constexpr double least_counts = 512;
/// The shortest steps that decide whether branches meet or miss one another, as a part of the way
/// that moves the mechanism by its size. In shorter ones near a meeting, rounding hides the turning
/// of links.
constexpr double least_counting_step = 1e-7;
/// Where branches meet at the first step, turns are counted from a set beside it, at this part of
/// the way that moves the mechanism by its size.
constexpr double beside_first = 1e-5;
/// The largest number of steps that lead to one value.
constexpr int most_counting_steps = 4096;
/// Whether some group's loop Jacobian has no sign, as where its configurations meet.
bool lacks_signs(const Snapshot& snapshot) {
  return std::ranges::any_of(
      snapshot.solution.configurations, [](const Configuration& configuration) {
        return std::ranges::any_of(configuration.determinants,
                                   [](double determinant) { return std::isnan(determinant); });
      });
}

/// The joints whose coordinates laws read.
std::vector<JointIndex> joints_that_laws_read(const Mechanism& mechanism) {
  std::vector<JointIndex> read;
  for (const DriverIndex driver : mechanism.drivers().keys()) {
    const auto joints = plan::joints_read(mechanism, driver);
    read.insert(read.end(), joints.begin(), joints.end());
  }
  return read;
}

bool has_angles(const Mechanism& mechanism, const std::vector<JointIndex>& joints) {
  return std::ranges::any_of(joints, [&](JointIndex joint) {
    return mechanism.joints()[joint].type == JointType::revolute;
  });
}

Eigen::Index column_of(const std::vector<ParameterIndex>& columns, ParameterIndex parameter) {
  return std::find(columns.begin(), columns.end(), parameter) - columns.begin();
}

/// Configurations closer than this may be one, which only all constraints together determine.
constexpr double closest_settled = 1e-9;

/// The speed at which a number changes, in units per parameter. If it is stationary, the inverse of
/// the parameter's change until the number has changed by a unit.
double speed_of(const models::Series& number, double unit) {
  return std::max(std::abs(number.c[1]) / unit, std::sqrt(std::abs(number.c[2]) / unit));
}

}  // namespace

SnapshotSolver::SnapshotSolver(const Plan& plan, Values values)
    : plan_(plan),
      values_(std::move(values)),
      solver_(values_),
      column_(column_of(values_.columns(), sweep().parameter)),
      read_(joints_that_laws_read(plan.mechanism())),
      counted_(has_angles(plan.mechanism(), read_), column_) {
  from_ = values_.value_of(sweep().from);
  to_ = values_.value_of(sweep().to);
  sought_.length = solve::longest_on_links(values_at(from_));
  moved_features_ = solve::features_moved_by(values_, sweep().parameter);
}

Values& SnapshotSolver::values_at(double parameter) {
  values_.set(sweep().parameter, parameter);
  return values_;
}

void SnapshotSolver::expect_values_at_steps() {
  for (int step = 0; step < sweep().count; ++step) {
    values_.set(sweep().parameter, value_at_step(from_, to_, step, sweep().count));
  }
}

Eigen::VectorXd SnapshotSolver::place_of(const Configuration& configuration) const {
  ConfigurationPoint point;
  find_point(configuration, point);
  return point.at;
}

double SnapshotSolver::speed_on_links(double parameter) {
  const Values& values = values_at(parameter);
  const Mechanism& mechanism = plan_.mechanism();
  const solve::AlongParameter along(values, sweep().parameter);
  double fastest = 0;
  for (const FeatureIndex index : moved_features_) {
    const Feature& feature = mechanism.features()[index];
    const double turn = values.frame(index).follows.first(2, column_);
    fastest = std::max({fastest, std::abs(turn), speed_of(along.number(feature.x), sought_.length),
                        speed_of(along.number(feature.y), sought_.length)});
  }
  for (const DriverIndex driver : mechanism.drivers().keys()) {
    const Joint& joint = mechanism.joints()[mechanism.drivers()[driver].joint];
    fastest = std::max(fastest, speed_of(along.laws()[driver],
                                         joint.type == JointType::revolute ? 1 : sought_.length));
  }
  return fastest;
}

double SnapshotSolver::way_of_size(const Snapshot& set) {
  if (set.count() == 0) {
    return 0;
  }
  const Table<LinkIndex, bool> is_driven = plan_.structure().placed_by_drivers();
  double speed = speed_on_links(set.parameter);
  for (const LinkIndex link : is_driven.keys()) {
    if (is_driven[link]) {
      speed = std::max(speed, set.points[PointIndex(0)].slope.segment<4>(4 * link.row()).norm());
    }
  }
  return speed > 0 ? 1 / speed : std::abs(set.parameter);
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
  begin_step();
  if (!counted_.is_empty()) {
    counted_.forget_all_but(counted_.nearest(parameter));
  }
  SnapshotPointer set = solved(parameter, true);
  counted_.note(set, is_count_ambiguous_);
  if (counted_.is_empty() && has_counted_angles(*set)) {
    const SnapshotPointer beside = solved_here(
        parameter + std::copysign(beside_first * way_of_size(*set), to_ - from_), false);
    counted_.note(beside, is_count_ambiguous_);
  }
  return set;
}

std::unique_ptr<Snapshot> SnapshotSolver::begun(double parameter) {
  const Values& values = values_at(parameter);
  std::unique_ptr<Snapshot> snapshot = spare();
  snapshot->parameter = parameter;
  snapshot->has_own_family = false;
  snapshot->spread = values.spread();
  snapshot->roles.resize(plan_.structure().groups.size());
  for (const GroupIndex group : snapshot->roles.keys()) {
    snapshot->roles[group] = values.group(group).roles;
  }
  return snapshot;
}

/// The set at a value. If laws read angles, their turns are counted in small steps from the nearest
/// set in which they are known. A step that may cross a place where branches meet, or miss one
/// another, is shortened until their continuations are known, or as far as is useful. A remaining
/// doubt may last, as where a branch stays singular; until it ends, the steps grow, since shorter
/// ones would not remove it. Far beyond the sweep, where only a wrong guess can lead, no steps are
/// taken.
SnapshotPointer SnapshotSolver::solved(double parameter, bool finds_motions) {
  if (counted_.is_empty()) {
    return solved_here(parameter, finds_motions);
  }
  const SnapshotPointer nearest = counted_.nearest(parameter);
  double here = nearest->parameter;
  const double range = std::abs(to_ - from_);
  const double whole = std::abs(parameter - here);
  const double rounding =
      16 * std::numeric_limits<double>::epsilon() * std::max(std::abs(here), std::abs(parameter));
  const double widest = std::max(rounding, std::max(range, whole) / least_counts);
  int left = whole > range && whole > way_of_size(*nearest) ? 0 : most_counting_steps;
  bool does_doubt_last = false;
  for (double width = widest;; --left) {
    const double rest = parameter - here;
    const bool arrives = std::abs(rest) <= width || left <= 0;
    const double next = arrives ? parameter : here + std::copysign(width, rest);
    solver_.count_from(counted_.beside(next, here));
    SnapshotPointer set = solved_here(next, arrives && finds_motions);
    const double way = std::abs(next - here);
    const bool is_in_doubt = is_count_in_doubt_ || (has_counted_angles(*set) && !is_regular(*set));
    if (is_in_doubt && !does_doubt_last && left > 0 &&
        way > std::max(rounding, least_counting_step * way_of_size(*set))) {
      width = way / 2;
    } else if (arrives) {
      return set;
    } else {
      does_doubt_last = is_in_doubt;
      counted_.note(set, is_count_ambiguous_);
      here = next;
      width = std::min(widest, 2 * std::max(way, rounding));
    }
  }
}

SnapshotPointer SnapshotSolver::solved_here(double parameter, bool finds_motions) {
  std::unique_ptr<Snapshot> snapshot = begun(parameter);
  (void)solver_.solve({.within_limits = false, .finds_motions = finds_motions}, solve::SoughtAll{},
                      snapshot->solution);
  is_count_in_doubt_ = solver_.is_count_in_doubt();
  is_count_ambiguous_ = solver_.is_count_ambiguous();
  if (snapshot->solution.configurations.size() > most_followed) {
    throw MechanismError("sweep", "more than " + std::to_string(most_followed) +
                                      " configurations at one value cannot be followed; follow "
                                      "one of them alone, by its number or a reference");
  }
  std::shared_ptr<Snapshot> set = completed(std::move(snapshot));
  const bool has_less = has_less_than_beside(*set);
  set->has_own_family = has_less && set->solution.families.size() > families_;
  set->separable = set->separable && !has_less;
  return set;
}

bool SnapshotSolver::has_less_than_beside(const Snapshot& set) {
  constexpr double little = 1e-5;  // of the way that moves the mechanism by its size
  const std::size_t families = set.solution.families.size();
  const bool is_merged = !plan_.redundant().empty() && lacks_signs(set);
  if (set.solution.status == SolutionStatus::degenerate || !(families > families_ || is_merged)) {
    families_ = std::min(families_, families);
    return false;
  }
  const bool is_behind_middle = 2 * set.parameter > from_ + to_;
  const double inward = is_behind_middle == (from_ < to_) ? from_ - to_ : to_ - from_;
  std::shared_ptr<const Snapshot> neighbour;
  try {
    auto snapshot = begun(set.parameter + std::copysign(little * way_of_size(set), inward));
    (void)solver_.solve({.within_limits = false, .finds_motions = false}, solve::SoughtAll{},
                        snapshot->solution);
    neighbour = completed(std::move(snapshot));
  } catch (const MechanismError&) {
    return false;  // A formula may have no value there.
  }
  families_ = std::min(families, neighbour->solution.families.size());
  return (families > families_ || is_merged) && neighbour->separable &&
         neighbour->count() > set.count();
}

SnapshotPointer SnapshotSolver::one_at(double parameter, std::size_t number) {
  std::unique_ptr<Snapshot> snapshot = begun(parameter);
  if (number == 0) {
    const solve::Answer answer = solver_.solve({}, solve::SoughtReference{}, snapshot->solution);
    if (answer.refusal) {
      throw OverConstrained(*answer.refusal);
    }
  } else {
    (void)plan_.solve_one(values_, number, snapshot->solution);
  }
  return completed(std::move(snapshot));
}

SnapshotPointer SnapshotSolver::near(double parameter, const Eigen::VectorXd& point,
                                     double farthest) {
  count_between_steps();
  if (!counted_.is_empty()) {
    solver_.count_from(counted_.beside(parameter, parameter));
  }
  std::unique_ptr<Snapshot> snapshot = begun(parameter);
  sought_.at = point;
  sought_.farthest = farthest;
  const std::optional<Nearest> found =
      solver_.solve({.within_limits = false}, &sought_, snapshot->solution).nearest;
  const std::shared_ptr<Snapshot> set = completed(std::move(snapshot));
  if (found && found->runner_up) {
    set->closest = *found->runner_up - found->distance;
  }
  return set;
}

void SnapshotSolver::count_between_steps() {
  if (++between_steps_ > most_between_steps) {
    throw MechanismError("sweep",
                         "between two steps the mechanism moves too far to be followed; "
                         "take more steps, or a shorter range");
  }
}

SnapshotPointer SnapshotSolver::at(double parameter) {
  count_between_steps();
  try {
    return solved(parameter, false);
  } catch (const MechanismError& error) {
    // Between steps a formula may have no value.
    auto snapshot = std::make_unique<Snapshot>();
    snapshot->parameter = parameter;
    snapshot->solution.status = SolutionStatus::degenerate;
    snapshot->solution.reason = error.what();
    return completed(std::move(snapshot));
  }
}

std::shared_ptr<Snapshot> SnapshotSolver::completed(std::unique_ptr<Snapshot> snapshot) const {
  snapshot->points.resize(snapshot->solution.configurations.size());
  for (const PointIndex point : snapshot->points.keys()) {
    find_point(snapshot->configuration(point), snapshot->points[point]);
  }
  snapshot->closest = least_distance(snapshot->points);
  snapshot->separable =
      is_regular(*snapshot) && (plan_.redundant().empty() || snapshot->closest > closest_settled);
  return {snapshot.release(), [spares = spares_](Snapshot* gone) { spares->emplace_back(gone); }};
}

void SnapshotSolver::find_point(const Configuration& configuration,
                                ConfigurationPoint& point) const {
  set_point(
      configuration, sought_.length,
      [this](const Frame& link) { return link.follows.first.col(column_); }, point);
}

}  // namespace assur::mechanism::follow
