// Follows every branch over the range of a swept parameter, with events, circuits and rows.
#include <algorithm>
#include <assur/mechanism/followed_parts.hpp>
#include <assur/mechanism/sweep.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <tuple>

#include "branch_tracker.hpp"
#include "circuit_finder.hpp"
#include "event_text.hpp"
#include "followable_set.hpp"
#include "followed_angles.hpp"
#include "shown_branches.hpp"
#include "solve/closure_error.hpp"
#include "sweep_range.hpp"
#include "unfollowed_interval.hpp"

namespace assur::mechanism::follow {
namespace {

/// The sweep is solved in at least this many intervals, however few steps it has. A pair of
/// branches that is born and ends again within one interval remains undetected.
constexpr int least_intervals = 512;
/// An event this near to a step, as a part of the way that moves the mechanism by its size, counts
/// as an event at the step. This is well above rounding, which depends on the listing and the unit,
/// and well below the distance at which sets can be followed.
constexpr double at_a_step = 5e-15;

/// The error of a crossing's place may be this many times the difference of its estimates, which
/// gives only the order of magnitude of the error.
constexpr double doubt_of_crossings = 3;

class Sweeper {
 public:
  Sweeper(const Plan& plan, const Values& values, const SweepObserver& observer)
      : observer_(observer),
        solver_(plan, values),
        tracker_(solver_),
        followed_(plan.mechanism()),
        told_(!plan.redundant().empty()) {
    if (observer.circuits) {
      circuits_.emplace(solver_);
    }
  }

  /// Watches the configurations at a value of the swept parameter within the sweep.
  void watch(double value) { watched_ = value; }
  /// The branches of the configurations with rows there, as `SweptPlaces` lists them.
  [[nodiscard]] std::vector<int> watched_branches() const {
    std::vector<int> shown;
    for (const int branch : watched_branches_) {
      shown.push_back(told_.shown_so_far(branch));
    }
    return shown;
  }

  /// Runs the sweep. Returns the number of branches.
  int run() {
    solver_.expect_values_at_steps();
    for (int step = 0; step < count(); ++step) {
      if (step > 0 && is_watched_between(value_at(step - 1), value_at(step))) {
        look_between();
      }
      const SnapshotPointer set = solver_.at_step(value_at(step));
      observer_.solved(set->parameter, set->solution);
      if (unfollowed_ && unfollowed_->covers(value_at(step), sense())) {
        pass_later(step, *set);
      } else if (set->separable) {
        unfollowed_.reset();
        pass(step, set);
      } else {
        pass_beside(step, set);
      }
      observer_.progress(step + 1);
    }
    report_events(count() - 1, later_.end());
    if (circuits_) {
      observer_.circuits(circuits_->found(told_));
    }
    return told_.count();
  }

 private:
  [[nodiscard]] double range() const { return solver_.to() - solver_.from(); }
  [[nodiscard]] double sense() const { return range() < 0 ? -1 : 1; }
  [[nodiscard]] int count() const { return solver_.sweep().count; }
  [[nodiscard]] double step_width() const { return std::abs(range()) / std::max(1, count() - 1); }
  [[nodiscard]] double value_at(int step) const {
    return value_at_step(solver_.from(), solver_.to(), step, count());
  }
  /// The rounding error of a step's value.
  [[nodiscard]] double rounding_of_steps() const {
    return 4 * std::numeric_limits<double>::epsilon() *
           std::max(std::abs(solver_.from()), std::abs(solver_.to()));
  }

  void pass(int step, const SnapshotPointer& set) {
    if (tracker_.running()) {
      advance(set);
    } else {
      begin(set, set->parameter);
    }
    take_events();
    report(step, *set, rows_of_tracker(*set));
  }

  /// Handles a step whose set cannot be followed, since branches meet there or it is degenerate:
  /// sets on both sides of it are connected instead.
  void pass_beside(int step, const SnapshotPointer& set) {
    const double value = set->parameter;
    const EventKind kind = set->is_degenerate() ? EventKind::degenerate : EventKind::unresolved;
    const SnapshotPointer before =
        nearest_followable_set(solver_, tracker_.current(), {step, set, -1});
    const SnapshotPointer after =
        nearest_followable_set(solver_, tracker_.current(), {step, set, 1});
    if (before && tracker_.running()) {
      advance(before);
    } else if (before) {
      begin(before, before->parameter);
    }
    IntervalEnd from;
    if (tracker_.running()) {
      from = {with_all_rates(tracker_.current()), tracker_.branches()};
    }
    take_events();
    const std::ptrdiff_t told = until(value) - later_.begin();
    const bool is_told_before = !after && !tracker_.running() && gap_;
    if (after && tracker_.running()) {
      tracker_.advance(after);
      take_events();
    } else if (after) {
      begin(after, value);
      if (step == 0) {
        add_end_events(after, value);
      }
    } else if (before && step + 1 == count()) {
      add_end_events(before, value);
    } else if (kind == EventKind::degenerate) {
      (void)tracker_.stop();
      gap_ = kind;
    }
    const std::vector<int> branches_before = from.branches.items();
    IntervalEnd to;
    if (after) {
      to = {after, tracker_.branches()};
    }
    const std::vector<int> branches_after = to.branches.items();
    // In an interval longer than a step it is unknown on which side of an event a row lies.
    const bool is_wide =
        from.set && to.set && std::abs(to.set->parameter - from.set->parameter) > step_width();
    unresolved_ =
        is_wide ? left_unresolved({later_.begin() + told, later_.end()}) : std::set<int>();
    forget_outside(from);
    forget_outside(to);
    unfollowed_.emplace(std::move(from), std::move(to), solver_.length());
    std::vector<StepRow> rows = unfollowed_->rows(*set);
    if (kind == EventKind::degenerate && !is_told_before) {
      add_degenerate(*set, rows, branches_before, branches_after,
                     {later_.begin() + told, later_.end()});
    }
    if (kind == EventKind::unresolved) {
      if (!before && !after) {  // The branches followed before are too far away to own these rows.
        std::ranges::for_each(rows, [](StepRow& row) { row.branch = 0; });
      }
      add_unresolved(step, value, rows);
    }
    report(step, *set, rows);
  }

  /// The set with all its rates. Those with fewer than two digits still tell branches apart, but
  /// are NaN in the sets at steps.
  [[nodiscard]] SnapshotPointer with_all_rates(const SnapshotPointer& set) {
    if (std::ranges::all_of(set->solution.configurations, &Configuration::rates_known)) {
      return set;
    }
    const SnapshotPointer same = solver_.at(set->parameter);
    return same->count() == set->count() ? same : set;
  }

  /// Adds an unresolved event where no set can be followed beyond the first or last step, for the
  /// branches in neither rows nor events; and where none can be followed on either side of a step,
  /// for the gap that begins there.
  void add_unresolved(int step, double value, const std::vector<StepRow>& rows) {
    const bool is_new_gap = !unfollowed_->leads_in() && !unfollowed_->leads_on() && !gap_;
    if (is_new_gap) {
      gap_ = EventKind::unresolved;
    }
    std::vector<int> ended;
    std::vector<int> begun;
    if (step + 1 == count() && !unfollowed_->leads_on()) {
      ended = untold(unfollowed_->branches_before(), rows, {until(value), later_.end()});
    }
    if (step == 0 && !unfollowed_->leads_in()) {
      begun = untold(unfollowed_->branches_after(), rows, {until(value), later_.end()});
    }
    if (is_new_gap || !ended.empty() || !begun.empty()) {
      later_.push_back(gap_event(EventKind::unresolved, value, std::move(ended), std::move(begun)));
    }
  }

  /// Handles a step within the interval of an earlier step.
  void pass_later(int step, const Snapshot& set) {
    const std::vector<StepRow> rows = unfollowed_->rows(set);
    if (set.is_degenerate()) {
      const auto is_here = [&](const BranchEvent& event) {
        return event.parameter == set.parameter;
      };
      const auto first = until(set.parameter);
      add_degenerate(set, rows, unfollowed_->branches_before(), unfollowed_->branches_after(),
                     {first, std::find_if_not(first, later_.end(), is_here)});
    }
    report(step, set, rows);
  }

  /// Adds the event of a degenerate step, which names the branches without a row there. If other
  /// events explain the step, it is an event only for branches that have no configuration there, as
  /// in a family.
  void add_degenerate(const Snapshot& set, const std::vector<StepRow>& rows,
                      const std::vector<int>& before, const std::vector<int>& after,
                      std::span<const BranchEvent> events) {
    const std::vector<int> unplaced = unfollowed_->branches_without_place(set);
    const auto lost = [&](const std::vector<int>& branches) {
      const std::vector<int> unexplained = untold(branches, rows, events);
      std::vector<int> result = branches;
      std::erase_if(result, [&](int branch) {
        return std::ranges::find(rows, branch, &StepRow::branch) != rows.end() ||
               (std::ranges::find(unplaced, branch) == unplaced.end() &&
                std::ranges::find(unexplained, branch) == unexplained.end());
      });
      return result;
    };
    BranchEvent event = gap_event(EventKind::degenerate, set.parameter, lost(before), lost(after));
    if (events.empty() || !event.ended.empty() || !event.begun.empty()) {
      later_.insert(until(set.parameter), std::move(event));
    }
  }

  /// Whether the watched value lies between two steps; it is at a step to within rounding.
  [[nodiscard]] bool is_watched_at(double step) const {
    return watched_ && std::abs(*watched_ - step) <= rounding_of_steps();
  }
  [[nodiscard]] bool is_watched_between(double before, double after) const {
    return watched_ && !is_watched_at(before) && !is_watched_at(after) &&
           (*watched_ - before) * (*watched_ - after) < 0;
  }

  /// Goes on to the watched value between two steps.
  void look_between() {
    const SnapshotPointer set = solver_.at(*watched_);
    if (unfollowed_ && unfollowed_->covers(*watched_, sense())) {
      note_watched(*set, unfollowed_->rows(*set));
    } else if (tracker_.running() && set->separable) {
      unfollowed_.reset();
      advance(set);
      note_watched(*set, rows_of_tracker(*set));
    }
  }

  void note_watched(const Snapshot& set, const std::vector<StepRow>& rows) {
    watched_branches_.clear();
    for (const PointIndex point : set.points.keys()) {
      if (is_told(set.configuration(point))) {
        const auto row = std::ranges::find(rows, point, &StepRow::point);
        watched_branches_.push_back(row == rows.end() ? 0 : row->branch);
      }
    }
  }

  [[nodiscard]] std::vector<StepRow> rows_of_tracker(const Snapshot& set) const {
    std::vector<StepRow> rows;
    for (const PointIndex point : set.points.keys()) {
      rows.push_back({point, tracker_.branches()[point], &set.configuration(point)});
    }
    return rows;
  }

  /// Reports the events since the last step, which may involve branches that have their first rows
  /// at this step, and then the rows of this step.
  void report(int step, const Snapshot& set, const std::vector<StepRow>& rows) {
    for (const StepRow& row : rows) {
      told_.note(row);
    }
    report_events(step - 1, until(set.parameter));
    for (const StepRow& row : rows) {
      report_row(step, set, row);
    }
    if (circuits_) {
      circuits_->join_at_step(set.parameter, rows);
    }
    if (is_watched_at(set.parameter)) {
      note_watched(set, rows);
    }
  }

  /// Begins to follow branches. After a gap this is an event, at `place`.
  void begin(const SnapshotPointer& set, double place) {
    tracker_.begin(set);
    if (gap_) {
      later_.push_back(gap_event(*gap_, place, {}, tracker_.branches().items()));
      gap_.reset();
    }
  }

  /// Advances in equal parts, so that a sweep of few steps finds the same events as one of many.
  void advance(const SnapshotPointer& set) {
    const double from = tracker_.current()->parameter;
    const double whole = set->parameter - from;
    const int parts =
        range() == 0 ? 1 : static_cast<int>(std::ceil(std::abs(whole / range()) * least_intervals));
    for (int part = 1; part < parts; ++part) {
      const SnapshotPointer middle = solver_.at(from + whole * part / parts);
      if (middle->separable) {
        tracker_.advance(middle);
      }
    }
    tracker_.advance(set);
  }

  /// Adds the folds and births at the first or last value itself.
  void add_end_events(const SnapshotPointer& near, double end) {
    for (SingularEvent& event : folds_at_end(solver_, near, end)) {
      BranchEvent named{event.kind, end, {}, {}, 0, std::move(event.configuration)};
      for (const PointIndex point : event.left) {
        named.ended.push_back(tracker_.branches()[point]);
      }
      std::sort(named.ended.begin(), named.ended.end());
      for (const PointIndex point : event.right) {
        named.begun.push_back(tracker_.branches()[point]);
      }
      std::sort(named.begun.begin(), named.begun.end());
      later_.push_back(std::move(named));
    }
  }

  [[nodiscard]] BranchEvent gap_event(EventKind kind, double value, std::vector<int> before,
                                      std::vector<int> after) const {
    return {
        kind, value, std::move(before), std::move(after), 0, unknown_configuration(solver_.plan())};
  }

  void report_row(int step, const Snapshot& set, const StepRow& row) {
    // Beyond the limits of joints angles go on, too.
    const bool is_followed = followed_.is_needed() && row.branch > 0;
    const Configuration& state =
        is_followed ? followed_.on(row.branch, *row.state, solver_.values_at(set.parameter))
                    : *row.state;
    if (!is_told(state)) {
      return;
    }
    const auto first = set.solution.configurations.begin();
    const auto within =
        std::count_if(first, first + static_cast<std::ptrdiff_t>(row.point.place()) + 1, is_told);
    observer_.record({step, static_cast<int>(within), told_.shown(row.branch), "", set.parameter,
                      &set.spread, &state});
  }

  /// Takes the tracker's events. Events at a step up to rounding are moved to the step, and those
  /// beyond the ends of the sweep are not reported.
  void take_events() {
    if (tracker_.running() && tracker_.current()->count() > 0) {
      way_of_size_ = solver_.way_of_size(*tracker_.current());
    }
    const double nearest = at_a_step * way_of_size_ + rounding_of_steps();
    for (BranchEvent& event : tracker_.take_events()) {
      const double middle = event.parameter;
      const double place = (event.parameter - solver_.from()) / range() * (count() - 1);
      const double step =
          value_at(static_cast<int>(std::clamp<double>(std::round(place), 0, count() - 1)));
      const double doubt = event.kind == EventKind::crossing ? doubt_of_crossings : 1;
      if (std::abs(event.parameter - step) <= std::max(doubt * event.uncertainty, nearest)) {
        event.parameter = step;
      }
      if (is_within(event)) {
        if (event.kind == EventKind::unresolved) {
          leave_unknown(event, middle);
        }
        later_.push_back(std::move(event));
      } else {
        if (event.kind != EventKind::crossing) {
          outside_.insert(event.ended.begin(), event.ended.end());
        }
        outside_.insert(event.begun.begin(), event.begun.end());
      }
    }
  }

  /// Handles an unresolved event, which lies anywhere within its uncertainty about a middle.
  /// Branches without rows that may end or begin beyond the ends of the sweep are not reported.
  void leave_unknown(BranchEvent& event, double middle) {
    const double reach = sense() * event.uncertainty;
    const auto is_outside = [this](int branch) {
      return !told_.has_row(branch) && outside_.insert(branch).second;
    };
    if (sense() * (middle - reach - solver_.from()) < 0) {
      std::erase_if(event.ended, is_outside);
    }
    if (sense() * (middle + reach - solver_.to()) > 0) {
      std::erase_if(event.begun, is_outside);
    }
  }

  /// Whether an event, and its branches, lie within the sweep.
  [[nodiscard]] bool is_within(const BranchEvent& event) const {
    const bool only_ends = event.kind == EventKind::fold || event.kind == EventKind::escape;
    const bool only_begins = event.kind == EventKind::birth || event.kind == EventKind::arrival;
    return (event.parameter - solver_.from()) * (event.parameter - solver_.to()) <= 0 &&
           !(only_ends && event.parameter == solver_.from()) &&
           !(only_begins && event.parameter == solver_.to());
  }

  /// Removes branches from an end of an interval: those that events outside the sweep end or begin,
  /// those that violate the redundant constraints, and unresolved ones, which have no rows in the
  /// interval.
  void forget_outside(IntervalEnd& end) const {
    for (const PointIndex point : end.branches.keys()) {
      int& branch = end.branches[point];
      if (outside_.contains(branch) || unresolved_.contains(branch) || told_.is_foreign(branch) ||
          !end.set->configuration(point).is_consistent) {
        branch = 0;
      }
    }
  }
  /// Sets an event's residual, forgets rates that are not known, and returns the spread of the
  /// parameters there. If a formula has no value at the event, the residual stays unknown and the
  /// spread is zero.
  [[nodiscard]] Spread complete(BranchEvent& event) {
    if (!event.configuration.rates_known) {
      for_each_followed(solver_.plan().mechanism(), solver_.plan().structure(), event.configuration,
                        [](auto& part) {
                          part.velocity *= std::numeric_limits<double>::quiet_NaN();
                          part.acceleration *= std::numeric_limits<double>::quiet_NaN();
                        });
    }
    try {
      const Values& values = solver_.values_at(event.parameter);
      event.configuration.residual =
          solve::closure_error(values, event.configuration, solver_.length());
      return values.spread();
    } catch (const MechanismError&) {
      const auto count = static_cast<Eigen::Index>(solver_.plan().mechanism().parameters().size());
      return {Eigen::VectorXd::Zero(count), Eigen::MatrixXd::Zero(count, count)};
    }
  }

  /// The first event at or after a value; they are in the order of the sweep.
  [[nodiscard]] std::vector<BranchEvent>::iterator until(double value) {
    return std::ranges::find_if(
        later_, [&](const BranchEvent& event) { return sense() * (event.parameter - value) >= 0; });
  }

  /// Sorts the events at a step, which were found in the intervals on both sides of it.
  void put_in_order(double value) {
    const auto first = until(value);
    const auto last = std::find_if(first, later_.end(), [value](const BranchEvent& event) {
      return event.parameter != value;
    });
    std::ranges::stable_sort(first, last, {}, [](const BranchEvent& event) {
      return std::tuple(event.kind, event.ended, event.begun);
    });
  }

  void report_events(int step, std::vector<BranchEvent>::iterator end) {
    put_in_order(value_at(std::max(step, 0)));
    for (auto event = later_.begin(); event != end; ++event) {
      if (told_.keeps_own(*event)) {
        if (circuits_) {
          circuits_->join_at(*event);
        }
        const Spread spread = complete(*event);
        told_.renumber(*event);
        observer_.record(
            {step, 0, 0, event_text(*event), event->parameter, &spread, &event->configuration});
      }
    }
    later_.erase(later_.begin(), end);
  }

  const SweepObserver& observer_;
  SnapshotSolver solver_;
  BranchTracker tracker_;
  FollowedAngles followed_;
  double way_of_size_ = 0;          ///< at the last set with configurations
  std::vector<BranchEvent> later_;  ///< not yet reported
  std::set<int> outside_;           ///< numbers of branches that are not within the sweep
  std::set<int> unresolved_;        ///< numbers of branches that have no rows in the interval
  ShownBranches told_;
  std::optional<CircuitFinder> circuits_;  ///< where they are asked for
  std::optional<double> watched_;
  std::vector<int> watched_branches_;
  std::optional<EventKind> gap_;  ///< the reason why no branch is followed at present
  std::optional<UnfollowedInterval> unfollowed_;  ///< the last one not followed step by step
};

/// Solving throws where redundant constraints do not hold as the sweep begins.
void expect_redundant_joints_to_hold(const Plan& plan, const Values& values) {
  if (!plan.redundant().empty()) {
    Values first = values;
    first.set(plan.request().sweep->parameter, values.value_of(plan.request().sweep->from));
    (void)plan.solve(first);
  }
}

}  // namespace

}  // namespace assur::mechanism::follow

namespace assur::mechanism {

int sweep(const Plan& plan, const SweepObserver& observer) {
  return sweep(plan, plan.values(), observer);
}

int sweep(const Plan& plan, const Values& values, const SweepObserver& observer) {
  const SweepObserver complete = follow::expect_sweep(plan, values, observer);
  follow::expect_redundant_joints_to_hold(plan, values);
  return follow::Sweeper(plan, values, complete).run();
}

SweptPlaces swept_places(const Mechanism& mechanism, const Request& request,
                         const std::function<void(int)>& progress) {
  SweptPlaces places;
  const Plan plan(mechanism, follow::positions_of(request));
  const Values values = plan.values();
  const SweepObserver observer = follow::expect_sweep(
      plan, values,
      {{}, {}, progress, [&places](const Circuits& circuits) { places.circuits = circuits; }});
  follow::expect_redundant_joints_to_hold(plan, values);
  follow::Sweeper sweeper(plan, values, observer);
  sweeper.watch(values.parameter(plan.request().sweep->parameter));
  (void)sweeper.run();
  places.branches = sweeper.watched_branches();
  return places;
}

}  // namespace assur::mechanism
