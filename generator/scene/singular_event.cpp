#include "scene/singular_event.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace assur::generator {

namespace {

using Events = std::vector<SingularEvent>;

/// A crossing and a gap d between two branches differ by d^2 / separation over an interval. What
/// is below this product is a change of the lengths by rounding.
constexpr double crossing_limit = 5e-13;
/// A third branch within a fold: the pair must be as close, and the third as near to its middle.
constexpr double through_separation = 2e-3;
constexpr double through_offset = 0.02;
/// Sizes from which on a branch may be on its way to infinity.
constexpr double far_away = 50;

std::size_t slot(int index) { return static_cast<std::size_t>(index); }

/// The side of an interval where the configurations in question exist, and its other end.
struct Side {
  SnapshotPointer near;
  double end;
  bool is_left;

  [[nodiscard]] double reach() const { return end - near->parameter; }
  /// Whether an estimate lies within the interval. It may overshoot a little; the located value
  /// may not.
  [[nodiscard]] bool reaches(double distance, double slack) const {
    const double part = distance / reach();
    return part > 0 && part < 1 + slack;
  }
};

class Explanation {
 public:
  Explanation(const SnapshotSolver& solver, BranchMatching& matching)
      : solver_(solver), matching_(matching) {}

  [[nodiscard]] std::optional<Events> run(const SnapshotPointer& left,
                                          const SnapshotPointer& right) {
    if (!explain_crossings(left, right) ||
        !explain_alone({left, right->parameter, true}, matching_.left_alone) ||
        !explain_alone({right, left->parameter, false}, matching_.right_alone)) {
      return std::nullopt;
    }
    put_in_order(right->parameter < left->parameter ? -1 : 1);
    return std::move(events_);
  }

  /// Folds of pairs among `alone`; false if one of these is in no fold of the interval.
  [[nodiscard]] bool explain_alone(const Side& side, std::vector<int> alone) {
    alone.erase(std::remove_if(alone.begin(), alone.end(),
                               [&](int index) { return explain_escape(side, index); }),
                alone.end());
    while (alone.size() > 1) {
      const auto [one, other] = closest(*side.near, alone);
      if (!explain_fold({side.near, std::min(one, other), std::max(one, other)}, side)) {
        return false;
      }
      alone.erase(std::remove_if(alone.begin(), alone.end(),
                                 [&, one = one, other = other](int index) {
                                   return index == one || index == other;
                                 }),
                  alone.end());
    }
    return alone.empty();
  }

  /// False if the pair does not meet within the interval, away from all others.
  [[nodiscard]] bool explain_fold(const ConfigurationPair& pair, const Side& side) {
    constexpr double slack = 0.1;
    const double distance = pair.distance_to_fold();
    if (!side.reaches(distance, slack)) {
      return false;
    }
    int through = -1;
    if (!is_apart_from_others(pair, distance, through)) {
      return false;
    }
    const auto found = locate_fold(solver_, pair, through >= 0);
    if (!found) {
      return false;
    }
    // Within rounding the end itself may be the fold.
    const double rounding = 1e-13 * std::max(std::abs(side.end), std::abs(side.near->parameter));
    const double beyond =
        std::abs(found->parameter - side.near->parameter) - std::abs(side.reach());
    if (!side.reaches(found->parameter - side.near->parameter, slack) || beyond > rounding) {
      return false;
    }
    SingularEvent event{side.is_left ? EventKind::fold : EventKind::birth,
                        beyond > 0 ? side.end : found->parameter,
                        {},
                        {},
                        side.is_left || through < 0 ? through : on_left(through),
                        found->configuration};
    (side.is_left ? event.left : event.right) = {pair.one, pair.other};
    events_.push_back(std::move(event));
    return true;
  }

  [[nodiscard]] Events& events() { return events_; }

 private:
  static std::pair<int, int> closest(const Snapshot& set, const std::vector<int>& among) {
    std::pair<int, int> best{among[0], among[1]};
    double least = std::numeric_limits<double>::infinity();
    for (const int one : among) {
      for (const int other : among) {
        const double distance = (set.points[slot(one)].at - set.points[slot(other)].at).norm();
        if (one < other && distance < least) {
          least = distance;
          best = {one, other};
        }
      }
    }
    return best;
  }

  [[nodiscard]] int on_left(int right) const {
    const auto& list = matching_.to_right;
    const auto found = std::find(list.begin(), list.end(), right);
    return found == list.end() ? -1 : static_cast<int>(found - list.begin());
  }

  /// No other configuration is near the pair or where it will meet, but perhaps one right between.
  [[nodiscard]] static bool is_apart_from_others(const ConfigurationPair& pair, double distance,
                                                 int& through) {
    const double separation = pair.separation();
    const Eigen::VectorXd middle = (pair.first().at + pair.second().at) / 2;
    const Eigen::VectorXd middle_slope = (pair.first().slope + pair.second().slope) / 2;
    for (std::size_t index = 0; index < pair.set->count(); ++index) {
      const auto other = static_cast<int>(index);
      if (other == pair.one || other == pair.other) {
        continue;
      }
      const ConfigurationPoint& point = pair.set->points[index];
      const Eigen::VectorXd offset = point.at - middle;
      const Eigen::VectorXd later = offset + distance * (point.slope - middle_slope);
      if (offset.norm() > 2 * separation && later.norm() > separation) {
        continue;
      }
      if (through >= 0 || separation > through_separation ||
          offset.norm() > through_offset * separation) {
        return false;
      }
      through = other;
    }
    return true;
  }

  [[nodiscard]] bool explain_escape(const Side& side, int index) {
    constexpr double slack = 0.1;
    const ConfigurationPoint& point = side.near->points[slot(index)];
    if (point.at.norm() < far_away || !side.reaches(distance_to_escape(point), slack)) {
      return false;
    }
    const auto found = locate_escape(solver_, side.near, index);
    if (!found || !side.reaches(found->parameter - side.near->parameter, 0)) {
      return false;
    }
    SingularEvent event{side.is_left ? EventKind::escape : EventKind::arrival,
                        found->parameter,
                        {},
                        {},
                        -1,
                        found->configuration};
    (side.is_left ? event.left : event.right) = {index};
    events_.push_back(std::move(event));
    return true;
  }

  /// Crossings; other bundles of branches may be folds and births at one place.
  [[nodiscard]] bool explain_crossings(const SnapshotPointer& left, const SnapshotPointer& right) {
    for (const std::vector<int>& bundle : bundles(left->count())) {
      if (!is_crossing(bundle, left, right)) {
        for (const int index : bundle) {
          int& to = matching_.to_right[slot(index)];
          matching_.left_alone.push_back(index);
          matching_.right_alone.push_back(to);
          to = -1;
        }
        continue;
      }
      const auto [before, after] = pairs(left, right, bundle[0], bundle[1]);
      const auto found = locate_crossing(solver_, before, after);
      if (!found ||
          (found->parameter - left->parameter) * (found->parameter - right->parameter) > 0) {
        return false;
      }
      events_.push_back(
          {EventKind::crossing, found->parameter, bundle, {}, -1, found->configuration});
    }
    matching_.touching.clear();
    return true;
  }

  /// Two matched configurations on both sides.
  [[nodiscard]] std::pair<ConfigurationPair, ConfigurationPair> pairs(const SnapshotPointer& left,
                                                                      const SnapshotPointer& right,
                                                                      int one, int other) const {
    return {{left, one, other},
            {right, matching_.to_right[slot(one)], matching_.to_right[slot(other)]}};
  }

  [[nodiscard]] bool is_crossing(const std::vector<int>& bundle, const SnapshotPointer& left,
                                 const SnapshotPointer& right) const {
    for (const int one : bundle) {
      for (const int other : bundle) {
        const auto [before, after] = pairs(left, right, one, other);
        if (one < other && !is_crossing(before, after)) {
          return false;
        }
      }
    }
    return true;
  }

  /// By parameter; what differs by rounding alone, folds first, and then as the sets are listed.
  void put_in_order(double sense) {
    const double rounding = 1e-10 * std::abs(solver_.to() - solver_.from());
    const auto before = [=](const SingularEvent& one, const SingularEvent& other) {
      const double difference = one.parameter - other.parameter;
      if (std::abs(difference) > rounding) {
        return sense * difference < 0;
      }
      return one.kind != other.kind
                 ? one.kind < other.kind
                 : std::tie(one.left, one.right) < std::tie(other.left, other.right);
    };
    for (std::size_t last = 1; last < events_.size(); ++last) {
      for (std::size_t at = last; at > 0 && before(events_[at], events_[at - 1]); --at) {
        std::swap(events_[at], events_[at - 1]);
      }
    }
  }

  /// The branches that touch one another, directly or through others; two or more each.
  [[nodiscard]] std::vector<std::vector<int>> bundles(std::size_t count) const {
    std::vector<int> leader(count);
    std::iota(leader.begin(), leader.end(), 0);
    for (const TouchingPair& pair : matching_.touching) {
      const int from = leader[slot(pair.one)];
      const int to = leader[slot(pair.other)];
      std::replace(leader.begin(), leader.end(), std::max(from, to), std::min(from, to));
    }
    std::vector<std::vector<int>> lists(count);
    for (std::size_t index = 0; index < count; ++index) {
      lists[slot(leader[index])].push_back(static_cast<int>(index));
    }
    lists.erase(std::remove_if(lists.begin(), lists.end(),
                               [](const auto& list) { return list.size() < 2; }),
                lists.end());
    return lists;
  }

  /// Both branches go straight through to within rounding, and their difference turns round.
  [[nodiscard]] static bool is_crossing(const ConfigurationPair& before,
                                        const ConfigurationPair& after) {
    const double step = after.set->parameter - before.set->parameter;
    const double separation = std::max(before.separation(), after.separation());
    const double miss = std::max(defect(before.first(), after.first(), step),
                                 defect(before.second(), after.second(), step));
    const double turn =
        std::abs(step) * std::max((after.first().slope - before.first().slope).norm(),
                                  (after.second().slope - before.second().slope).norm());
    const double change = (after.apart() - before.apart()).norm();
    return miss * separation < crossing_limit && turn < 0.1 * separation &&
           change > 0.9 * (before.separation() + after.separation());
  }

  const SnapshotSolver& solver_;
  BranchMatching& matching_;
  Events events_;
};

}  // namespace

std::optional<Events> explain(const SnapshotSolver& solver, const SnapshotPointer& left,
                              const SnapshotPointer& right, BranchMatching& matching) {
  return Explanation(solver, matching).run(left, right);
}

Events folds_at_end(const SnapshotSolver& solver, const SnapshotPointer& near, double end) {
  const double sense = solver.to() < solver.from() ? -1 : 1;
  const Side side{near, end, sense * (end - near->parameter) > 0};
  BranchMatching nothing;
  Explanation explanation(solver, nothing);
  for (std::size_t one = 0; one < near->count(); ++one) {
    for (std::size_t other = 0; other < one; ++other) {
      (void)explanation.explain_fold({near, static_cast<int>(other), static_cast<int>(one)}, side);
    }
  }
  return std::move(explanation.events());
}

}  // namespace assur::generator
