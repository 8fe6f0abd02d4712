#include <algorithm>
#include <assur/mechanism/sweep.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "branch_tracker.hpp"
#include "solve/closure_error.hpp"

namespace assur::mechanism::follow {

namespace {

/// The sweep is solved at least at so many values, however few steps it has: a pair of branches
/// that is born and ends again between two of them is not seen.
constexpr int least_intervals = 512;
/// Beside a step whose configurations cannot be told apart, at first at this part of the sweep.
constexpr double beside = 1e-5;

std::string listed(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) {
    text += " " + std::to_string(number);
  }
  return text;
}

std::string event_text(const BranchEvent& event) {
  const std::string on = event.through > 0 ? " on " + std::to_string(event.through) : "";
  switch (event.kind) {
    case EventKind::fold:
      return "fold" + listed(event.ended) + on;
    case EventKind::birth:
      return "birth" + listed(event.begun) + on;
    case EventKind::crossing:
      return "crossing" + listed(event.ended);
    case EventKind::escape:
      return "escape" + listed(event.ended);
    case EventKind::arrival:
      return "arrival" + listed(event.begun);
    case EventKind::degenerate:
      return "degenerate" + listed(event.ended) + " /" + listed(event.begun);
    case EventKind::unresolved:
      return "unresolved" + listed(event.ended) + " /" + listed(event.begun);
  }
  return "";
}

class Sweeper {
 public:
  Sweeper(const Plan& plan, const Values& values, const SweepObserver& observer)
      : observer_(observer), solver_(plan, values), tracker_(solver_) {}

  void run() {
    for (int step = 0; step < count(); ++step) {
      (void)solver_.values_at(value_at(step));
    }
    for (int step = 0; step < count(); ++step) {
      const SnapshotPointer set = solver_.at_step(value_at(step));
      observer_.solved(set->solution);
      if (set->separable) {
        pass(step, set);
      } else {
        pass_beside(step, set);
      }
      observer_.progress(step + 1);
    }
  }

 private:
  [[nodiscard]] double range() const { return solver_.to() - solver_.from(); }
  [[nodiscard]] int count() const { return solver_.sweep().count; }
  [[nodiscard]] double value_at(int step) const {
    const int last = count() - 1;
    return last == 0 ? solver_.from()
                     : solver_.from() + range() * (static_cast<double>(step) / last);
  }

  void pass(int step, const SnapshotPointer& set) {
    if (tracker_.running()) {
      advance(set);
    } else {
      tracker_.begin(set);
      if (gap_) {
        later_.push_back(gap_event(*gap_, set->parameter, {}, tracker_.branches().items()));
      }
    }
    gap_.reset();
    take_events();
    report_events(step - 1, set->parameter);
    for (const PointIndex point : set->points.keys()) {
      report_row(step, *set, point, tracker_.branches()[point], set->configuration(point));
    }
    report_events(step, std::nullopt);
  }

  /// A step at which branches meet, or worse: sets on both sides of it are connected instead.
  void pass_beside(int step, const SnapshotPointer& set) {
    const double value = set->parameter;
    const EventKind kind = set->solution.status == SolutionStatus::degenerate
                               ? EventKind::degenerate
                               : EventKind::unresolved;
    const bool last = step + 1 == count();
    const SnapshotPointer before = tracker_.running() ? set_beside(value, -1) : nullptr;
    const SnapshotPointer after = last ? nullptr : set_beside(value, 1);
    std::vector<Candidate> candidates;
    if (before) {
      advance(before);
      add_candidates(value, candidates);
    }
    take_events();
    report_events(step - 1, value);
    if (before && after) {
      const std::vector<int> numbers = tracker_.branches().items();
      tracker_.advance(after);
      take_events();
      if (later_.empty() && kind == EventKind::degenerate) {
        later_.push_back(gap_event(kind, value, numbers, tracker_.branches().items()));
      }
    } else if (before && last) {
      add_end_events(before, value);
    } else if (tracker_.running() && kind == EventKind::unresolved) {
      // The next set that can be followed is connected with the current one, past this step.
      add_candidates(value, candidates);
    } else if (tracker_.running()) {
      later_.push_back(gap_event(kind, value, tracker_.stop(), {}));
      gap_ = kind;
    } else if (!gap_ && !after && kind == EventKind::degenerate) {
      later_.push_back(gap_event(kind, value, {}, {}));
      gap_ = kind;
    }
    if (after && !tracker_.running()) {
      tracker_.begin(after);
      if (gap_) {
        later_.push_back(gap_event(*gap_, value, {}, tracker_.branches().items()));
        gap_.reset();
      }
      if (step == 0) {
        add_end_events(after, value);
      }
    }
    if (after && tracker_.current() == after) {
      add_candidates(value, candidates);
    }
    report_events(step - 1, value);
    report_nearest(step, *set, candidates);
    report_events(step, std::nullopt);
  }

  /// In equal parts, so that few steps see what many do.
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

  /// The nearest set that can be followed, on one side of a step and nearer than the next.
  [[nodiscard]] SnapshotPointer set_beside(double value, int side) {
    const double step = range() / std::max(1, count() - 1);
    double distance = std::min(beside * std::abs(range()), std::abs(step) / 8);
    for (; distance > 0 && distance < std::abs(step) / 2; distance *= 4) {
      const double place = value + std::copysign(distance, step) * side;
      const bool passed = tracker_.running() && (place - tracker_.current()->parameter) * step <= 0;
      if (passed) {
        break;
      }
      if (SnapshotPointer set = solver_.at(place); set->separable) {
        return set;
      }
    }
    return nullptr;
  }

  /// A fold at the first or last value itself.
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

  /// Where a branch is expected at a step that could not be matched.
  struct Candidate {
    int branch;
    Eigen::VectorXd place;
    SnapshotPointer set;  ///< the set beside the step, and its point there
    PointIndex point;
  };
  void add_candidates(double value, std::vector<Candidate>& candidates) const {
    const Snapshot& set = *tracker_.current();
    for (const PointIndex index : set.points.keys()) {
      const ConfigurationPoint& point = set.points[index];
      candidates.push_back({tracker_.branches()[index],
                            point.at + (value - set.parameter) * point.slope, tracker_.current(),
                            index});
    }
  }

  /// A row belongs to the branches that expect nothing nearer than it. Each of those that go
  /// through a crossing has a row, with its own rates where they are known; otherwise the least of
  /// their numbers is given, or none to a row that exists at this step alone.
  void report_nearest(int step, const Snapshot& set, const std::vector<Candidate>& candidates) {
    std::vector<int> used;
    for (const PointIndex index : set.points.keys()) {
      std::vector<Candidate> expected;
      std::vector<int> numbers;
      for (const Candidate& candidate : candidates) {
        const bool taken = std::find(used.begin(), used.end(), candidate.branch) != used.end();
        if (!taken && is_nearest(candidate, index, set)) {
          expected.push_back(candidate);
          numbers.push_back(candidate.branch);
        }
      }
      std::sort(numbers.begin(), numbers.end());
      std::vector<int> through;  // expected from both sides
      for (auto next = numbers.begin();
           (next = std::adjacent_find(next, numbers.end())) != numbers.end(); ++next) {
        through.push_back(*next);
      }
      const Configuration& here = set.configuration(index);
      std::vector<std::pair<int, const Configuration*>> rows;
      for (const Configuration& branch : here.branches) {
        const int number = number_of(branch, expected);
        expected.erase(std::remove_if(expected.begin(), expected.end(),
                                      [number](const Candidate& candidate) {
                                        return candidate.branch == number;
                                      }),
                       expected.end());
        rows.emplace_back(number, &branch);
      }
      for (const int number : through) {
        if (here.branches.empty() && through.size() > 1) {
          rows.emplace_back(number, &here);
        }
      }
      if (rows.empty()) {
        rows.emplace_back(numbers.empty() ? 0 : numbers.front(), &here);
      }
      std::stable_sort(rows.begin(), rows.end(),
                       [](const auto& one, const auto& other) { return one.first < other.first; });
      for (const auto& [number, state] : rows) {
        report_row(step, set, index, number, *state);
      }
      used.insert(used.end(), numbers.begin(), numbers.end());
    }
  }
  /// Of the branches that are expected, the one that moves most nearly so.
  [[nodiscard]] int number_of(const Configuration& branch,
                              const std::vector<Candidate>& expected) const {
    double least = std::numeric_limits<double>::infinity();
    int number = 0;
    for (const Candidate& candidate : expected) {
      const Configuration& nearby = candidate.set->configuration(candidate.point);
      double difference = 0;
      for (const LinkIndex link : branch.links.keys()) {
        const Eigen::Vector3d apart = branch.links[link].velocity - nearby.links[link].velocity;
        difference =
            std::max({difference, apart.head<2>().norm() / solver_.length(), std::abs(apart(2))});
      }
      if (difference < least) {
        least = difference;
        number = candidate.branch;
      }
    }
    return number;
  }
  /// Two rows that are one to rounding count as equally near.
  static bool is_nearest(const Candidate& candidate, PointIndex index, const Snapshot& set) {
    const double distance = (candidate.place - set.points[index].at).norm();
    return std::all_of(set.points.begin(), set.points.end(), [&](const ConfigurationPoint& other) {
      return distance <= (candidate.place - other.at).norm() + 1e-6;
    });
  }

  void report_row(int step, const Snapshot& set, PointIndex point, int branch,
                  const Configuration& state) const {
    observer_.record({step, static_cast<int>(point.place()) + 1, branch, "", set.parameter,
                      &set.spread, &state});
  }

  void take_events() {
    for (BranchEvent& event : tracker_.take_events()) {
      later_.push_back(std::move(event));
    }
  }

  /// Fills in an event's residual; returns how the parameters vary there. Where a formula has no
  /// value at the event, the residual stays unknown and nothing varies.
  [[nodiscard]] Spread complete(BranchEvent& event) {
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

  /// Reports the events that lie before a value, or all.
  void report_events(int step, std::optional<double> until) {
    const double sense = range() < 0 ? -1 : 1;
    while (!later_.empty() && (!until || sense * (later_.front().parameter - *until) < 0)) {
      BranchEvent& event = later_.front();
      const Spread spread = complete(event);
      observer_.record(
          {step, 0, 0, event_text(event), event.parameter, &spread, &event.configuration});
      later_.erase(later_.begin());
    }
  }

  const SweepObserver& observer_;
  SnapshotSolver solver_;
  BranchTracker tracker_;
  std::vector<BranchEvent> later_;  ///< not yet reported
  std::optional<EventKind> gap_;    ///< why no branch is followed at present
};

}  // namespace

}  // namespace assur::mechanism::follow

namespace assur::mechanism {

void sweep(const Plan& plan, const SweepObserver& observer) {
  sweep(plan, plan.values(), observer);
}

void sweep(const Plan& plan, const Values& values, const SweepObserver& observer) {
  if (!plan.request().sweep) {
    throw MechanismError("sweep", "the request has no sweep");
  }
  plan.expect_usable(values);
  SweepObserver complete = observer;
  if (!complete.record) {
    complete.record = [](const SweepRecord&) {};
  }
  if (!complete.solved) {
    complete.solved = [](const Solution&) {};
  }
  if (!complete.progress) {
    complete.progress = [](int) {};
  }
  follow::Sweeper(plan, values, complete).run();
}

}  // namespace assur::mechanism
