#include "singular_event.hpp"

#include <algorithm>
#include <assur/numeric/order.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

#include "crossing_location.hpp"
#include "escape_location.hpp"
#include "flat_fold.hpp"
#include "meeting_pairs.hpp"

namespace assur::mechanism::follow {

namespace {

using Events = std::vector<SingularEvent>;

/// A branch with a larger point may be on its way to infinity.
constexpr double far_away = 50;

class Explanation {
 public:
  Explanation(SnapshotSolver& solver, BranchMatching& matching, Explaining by)
      : solver_(solver), matching_(matching), by_(by) {}

  [[nodiscard]] std::optional<Events> run(const SnapshotPointer& left,
                                          const SnapshotPointer& right) {
    if (!explain_crossings(left, right) ||
        !explain_alone({left, right->parameter, true}, matching_.left_alone) ||
        !explain_alone({right, left->parameter, false}, matching_.right_alone)) {
      return std::nullopt;
    }
    put_in_order(right->parameter < left->parameter ? -1 : 1);
    if (!are_all(left, right) || !turns_are_explained(left, right)) {
      return std::nullopt;
    }
    return std::move(events_);
  }

  /// Explains the configurations in `alone` by folds of pairs. Returns false if one of them is in
  /// no fold of the interval.
  [[nodiscard]] bool explain_alone(const Side& side, std::vector<PointIndex> alone) {
    alone.erase(std::remove_if(alone.begin(), alone.end(),
                               [&](PointIndex index) { return explain_escape(side, index); }),
                alone.end());
    const std::vector<PointIndex> all = alone;
    while (alone.size() > 1) {
      const auto [one, other] = meeting(side, alone);
      if (!explain_fold({side.near, one, other}, side, all)) {
        return false;
      }
      alone.erase(std::remove_if(alone.begin(), alone.end(),
                                 [&, one = one, other = other](PointIndex index) {
                                   return index == one || index == other;
                                 }),
                  alone.end());
    }
    return alone.empty();
  }

  /// Explains a pair by a fold. Returns false if it does not meet within the interval, or if others
  /// are near it, except those of `alone` that meet in the same place.
  [[nodiscard]] bool explain_fold(const ConfigurationPair& pair, const Side& side,
                                  const std::vector<PointIndex>& alone) {
    constexpr double slack = 0.1;
    const auto flat = locate_flat_fold(solver_, pair);
    const double distance = flat ? flat->parameter - side.near->parameter : pair.distance_to_fold();
    if (!side.reaches(distance, slack)) {
      return false;
    }
    PointIndex through;
    if (!is_apart_from_others(pair, distance, alone, through)) {
      return false;
    }
    auto found = flat && !through.exists() ? flat : locate_fold(solver_, pair, through.exists());
    if (!found && by_ == Explaining::all_that_is) {
      found = locate_fold_from(solver_, pair);
    }
    if (!found) {
      return false;
    }
    // Up to rounding, the fold may be at the end itself.
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
                        side.is_left || !through.exists() ? through : on_left(through),
                        found->configuration,
                        found->uncertainty};
    (side.is_left ? event.left : event.right) = {pair.one, pair.other};
    events_.push_back(std::move(event));
    return true;
  }

  [[nodiscard]] Events& events() { return events_; }

 private:
  [[nodiscard]] PointIndex on_left(PointIndex right) const {
    for (const PointIndex left : matching_.to_right.keys()) {
      if (matching_.to_right[left] == right) {
        return left;
      }
    }
    return {};
  }

  [[nodiscard]] bool explain_escape(const Side& side, PointIndex index) {
    constexpr double slack = 0.1;
    const ConfigurationPoint& point = side.near->points[index];
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
                        PointIndex(),
                        found->configuration};
    (side.is_left ? event.left : event.right) = {index};
    events_.push_back(std::move(event));
    return true;
  }

  /// Explains bundles of branches by crossings. Other bundles may be folds and births at one place.
  [[nodiscard]] bool explain_crossings(const SnapshotPointer& left, const SnapshotPointer& right) {
    for (const std::vector<PointIndex>& bundle : bundles(left->count())) {
      const auto [before, after] = bundles_of(left, right, bundle);
      const auto found =
          change_sides(before, after) ? locate_crossing(solver_, before, after) : std::nullopt;
      if (!found && by_ == Explaining::crossings) {
        return false;
      }
      if (!found) {
        for (const PointIndex index : bundle) {
          PointIndex& to = matching_.to_right[index];
          matching_.left_alone.push_back(index);
          matching_.right_alone.push_back(to);
          to = PointIndex();
        }
        continue;
      }
      if ((found->parameter - left->parameter) * (found->parameter - right->parameter) > 0) {
        return false;
      }
      events_.push_back({EventKind::crossing,
                         found->parameter,
                         bundle,
                         {},
                         PointIndex(),
                         found->configuration,
                         found->uncertainty});
    }
    matching_.touching.clear();
    return true;
  }

  /// The bundles of matched configurations on both sides.
  [[nodiscard]] std::pair<ConfigurationBundle, ConfigurationBundle> bundles_of(
      const SnapshotPointer& left, const SnapshotPointer& right,
      const std::vector<PointIndex>& bundle) const {
    std::vector<PointIndex> matched;
    for (const PointIndex point : bundle) {
      matched.push_back(matching_.to_right[point]);
    }
    return {{left, bundle}, {right, matched}};
  }

  /// Sorts events by their parameter. Where parameters differ by rounding only, the kinds decide,
  /// folds first, and then the order of the sets.
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
    // Comparison up to rounding is not transitive, so a faster sort cannot rely on it.
    numeric::insertion_sort(
        events_.size(),
        [&](std::size_t one, std::size_t other) { return before(events_[one], events_[other]); },
        [&](std::size_t one, std::size_t other) { std::swap(events_[one], events_[other]); });
  }

  /// Whether each match whose determinant changes its sign goes through an event, or continues
  /// straight up to rounding, as where the mechanism moves freely at one value. If a gap w opened
  /// such a place, two branches would exchange places within w, with a defect of w / step.
  [[nodiscard]] bool turns_are_explained(const SnapshotPointer& left,
                                         const SnapshotPointer& right) const {
    const double step = right->parameter - left->parameter;
    return std::ranges::all_of(matching_.turned, [&](PointIndex point) {
      const PointIndex to = matching_.to_right[point];
      if (!to.exists() || is_singular_there(point)) {
        return true;
      }
      const ConfigurationPoint& before = left->points[point];
      const ConfigurationPoint& after = right->points[to];
      const double way = std::abs(step) * std::max(before.slope.norm(), after.slope.norm());
      return defect(before, after, step) * way < crossing_limit;
    });
  }

  /// Whether a branch goes through one of the events.
  [[nodiscard]] bool is_singular_there(PointIndex point) const {
    return std::ranges::any_of(events_, [point](const SingularEvent& event) {
      return event.through == point || (event.kind == EventKind::crossing &&
                                        std::ranges::find(event.left, point) != event.left.end());
    });
  }

  /// Whether the events account for the number of configurations between them: others may be born
  /// and end again within the interval. No set is computed between events that are close to one
  /// another.
  [[nodiscard]] bool are_all(const SnapshotPointer& left, const SnapshotPointer& right) {
    constexpr double close = 1e-2;
    std::size_t count = left->count();
    for (std::size_t index = 0; index + 1 < events_.size(); ++index) {
      const SingularEvent& event = events_[index];
      if (event.kind != EventKind::crossing) {
        count = count - event.left.size() + event.right.size();
      }
      const double step = events_[index + 1].parameter - event.parameter;
      if (std::abs(step) < close * std::abs(right->parameter - left->parameter)) {
        continue;
      }
      const SnapshotPointer middle = solver_.at(event.parameter + step / 2);
      if (middle->separable && middle->count() != count) {
        return false;
      }
    }
    return true;
  }

  /// The sets of two or more branches that touch one another, directly or through others.
  [[nodiscard]] std::vector<std::vector<PointIndex>> bundles(std::size_t count) const {
    Table<PointIndex, PointIndex> leader(count);
    for (const PointIndex point : leader.keys()) {
      leader[point] = point;
    }
    for (const TouchingPair& pair : matching_.touching) {
      const PointIndex from = leader[pair.one];
      const PointIndex to = leader[pair.other];
      std::replace(leader.begin(), leader.end(), std::max(from, to), std::min(from, to));
    }
    Table<PointIndex, std::vector<PointIndex>> lists(count);
    for (const PointIndex point : leader.keys()) {
      lists[leader[point]].push_back(point);
    }
    std::vector<std::vector<PointIndex>> bundles;
    std::copy_if(lists.begin(), lists.end(), std::back_inserter(bundles),
                 [](const auto& list) { return list.size() > 1; });
    return bundles;
  }

  /// Whether the difference of any two branches reverses its direction.
  [[nodiscard]] static bool change_sides(const ConfigurationBundle& before,
                                         const ConfigurationBundle& after) {
    constexpr double reversed = 0.6;  // the cosine of 53 degrees: branches bend while they cross
    for (std::size_t one = 0; one < before.count(); ++one) {
      for (std::size_t other = 0; other < one; ++other) {
        const Eigen::VectorXd earlier = before.at(other).at - before.at(one).at;
        const Eigen::VectorXd later = after.at(other).at - after.at(one).at;
        if (!(-earlier.dot(later) > reversed * earlier.norm() * later.norm())) {
          return false;
        }
      }
    }
    return true;
  }

  SnapshotSolver& solver_;
  BranchMatching& matching_;
  Explaining by_;
  Events events_;
};

}  // namespace

std::optional<Events> explain(SnapshotSolver& solver, const SnapshotPointer& left,
                              const SnapshotPointer& right, BranchMatching& matching,
                              Explaining by) {
  return Explanation(solver, matching, by).run(left, right);
}

Events folds_at_end(SnapshotSolver& solver, const SnapshotPointer& near, double end) {
  const double sense = solver.to() < solver.from() ? -1 : 1;
  const Side side{near, end, sense * (end - near->parameter) > 0};
  BranchMatching nothing;
  Explanation explanation(solver, nothing, Explaining::any_event);
  for (const PointIndex one : near->points.keys()) {
    for (const PointIndex other : near->points.keys()) {
      if (other < one) {
        (void)explanation.explain_fold({near, other, one}, side, {});
      }
    }
  }
  return std::move(explanation.events());
}

}  // namespace assur::mechanism::follow
