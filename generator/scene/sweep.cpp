#include "scene/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "scene/branch_tracker.hpp"
#include "scene/closure_error.hpp"

namespace assur::generator {

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
  Sweeper(const Scene& scene, const SweepObserver& observer)
      : scene_(scene), observer_(observer), solver_(scene), tracker_(solver_) {}

  void run() {
    for (int step = 0; step < scene_.sweep->count; ++step) {
      const SnapshotPointer set = solver_.at(value_at(step));
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
  [[nodiscard]] double value_at(int step) const {
    const int last = scene_.sweep->count - 1;
    return last == 0 ? solver_.from()
                     : solver_.from() + range() * (static_cast<double>(step) / last);
  }

  void pass(int step, const SnapshotPointer& set) {
    if (tracker_.running()) {
      advance(set);
    } else {
      tracker_.begin(set);
      if (gap_) {
        later_.push_back(gap_event(*gap_, set->parameter, {}, tracker_.branches()));
      }
    }
    gap_.reset();
    take_events();
    report_events(step - 1, set->parameter);
    for (std::size_t index = 0; index < set->count(); ++index) {
      report_row(step, *set, index, tracker_.branches()[index]);
    }
    report_events(step, std::nullopt);
  }

  /// A step at which branches meet, or worse: sets on both sides of it are connected instead.
  void pass_beside(int step, const SnapshotPointer& set) {
    const double value = set->parameter;
    const EventKind kind = set->solution.status == SolutionStatus::degenerate
                               ? EventKind::degenerate
                               : EventKind::unresolved;
    const bool last = step + 1 == scene_.sweep->count;
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
      const std::vector<int> numbers = tracker_.branches();
      tracker_.advance(after);
      take_events();
      if (later_.empty() && kind == EventKind::degenerate) {
        later_.push_back(gap_event(kind, value, numbers, tracker_.branches()));
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
        later_.push_back(gap_event(*gap_, value, {}, tracker_.branches()));
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
  [[nodiscard]] SnapshotPointer set_beside(double value, int side) const {
    const double step = range() / std::max(1, scene_.sweep->count - 1);
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
      for (const int index : event.left) {
        named.ended.push_back(tracker_.branches()[static_cast<std::size_t>(index)]);
      }
      std::sort(named.ended.begin(), named.ended.end());
      for (const int index : event.right) {
        named.begun.push_back(tracker_.branches()[static_cast<std::size_t>(index)]);
      }
      std::sort(named.begun.begin(), named.begun.end());
      later_.push_back(std::move(named));
    }
  }

  [[nodiscard]] BranchEvent gap_event(EventKind kind, double value, std::vector<int> before,
                                      std::vector<int> after) const {
    return {kind, value, std::move(before), std::move(after), 0, unknown_configuration(scene_)};
  }

  /// Where a branch is expected at a step that could not be matched.
  struct Candidate {
    int branch;
    Eigen::VectorXd place;
  };
  void add_candidates(double value, std::vector<Candidate>& candidates) const {
    const Snapshot& set = *tracker_.current();
    for (std::size_t index = 0; index < set.count(); ++index) {
      const ConfigurationPoint& point = set.points[index];
      candidates.push_back(
          {tracker_.branches()[index], point.at + (value - set.parameter) * point.slope});
    }
  }

  /// A row belongs to the branches that expect nothing nearer than it, and is given the least of
  /// their numbers; to none if it exists at this step alone.
  void report_nearest(int step, const Snapshot& set, const std::vector<Candidate>& candidates) {
    std::vector<int> numbers(set.count(), 0);
    std::vector<int> used;
    for (std::size_t index = 0; index < set.count(); ++index) {
      int& number = numbers[index];
      for (const Candidate& candidate : candidates) {
        const bool taken = std::find(used.begin(), used.end(), candidate.branch) != used.end();
        if (!taken && is_nearest(candidate, index, set) &&
            (number == 0 || candidate.branch < number)) {
          number = candidate.branch;
        }
      }
      used.push_back(number);
      report_row(step, set, index, number);
    }
  }
  /// Two rows that are one to rounding count as equally near.
  static bool is_nearest(const Candidate& candidate, std::size_t index, const Snapshot& set) {
    const double distance = (candidate.place - set.points[index].at).norm();
    return std::all_of(set.points.begin(), set.points.end(), [&](const ConfigurationPoint& other) {
      return distance <= (candidate.place - other.at).norm() + 1e-6;
    });
  }

  void report_row(int step, const Snapshot& set, std::size_t index, int branch) const {
    observer_.record({step, static_cast<int>(index) + 1, branch, "", &set.values,
                      &set.solution.configurations[index]});
  }

  void take_events() {
    for (BranchEvent& event : tracker_.take_events()) {
      later_.push_back(std::move(event));
    }
  }

  /// Reports the events that lie before a value, or all.
  void report_events(int step, std::optional<double> until) {
    const double sense = range() < 0 ? -1 : 1;
    while (!later_.empty() && (!until || sense * (later_.front().parameter - *until) < 0)) {
      BranchEvent& event = later_.front();
      const ParameterValues values(scene_, std::pair(scene_.sweep->parameter, event.parameter));
      AssemblyConfiguration& state = event.configuration;
      state.residual = closure_error(scene_, values, state, solver_.length());
      observer_.record({step, 0, 0, event_text(event), &values, &state});
      later_.erase(later_.begin());
    }
  }

  const Scene& scene_;
  const SweepObserver& observer_;
  SnapshotSolver solver_;
  BranchTracker tracker_;
  std::vector<BranchEvent> later_;  ///< not yet reported
  std::optional<EventKind> gap_;    ///< why no branch is followed at present
};

}  // namespace

void sweep(const Scene& scene, const SweepObserver& observer) { Sweeper(scene, observer).run(); }

}  // namespace assur::generator
