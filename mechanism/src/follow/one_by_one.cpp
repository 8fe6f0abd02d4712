#include "one_by_one.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "crossing_location.hpp"
#include "smooth_passing.hpp"

namespace assur::mechanism::follow {

namespace {

/// Branches that go through one configuration.
struct Meeting {
  std::vector<PointIndex> points;
  std::vector<SmoothPassing> passings;

  [[nodiscard]] const SmoothPassing& best() const {
    return *std::ranges::min_element(passings, {}, [](const SmoothPassing& passing) {
      return passing.location.configuration.residual;
    });
  }
};

class Follower {
 public:
  Follower(SnapshotSolver& solver, const SnapshotPointer& left, const SnapshotPointer& right)
      : branches_(solver), left_(left), right_(right) {}

  std::optional<OneByOne> run() {
    constexpr std::size_t most_branches = 32;  // Each one costs solving for all others.
    if (left_->count() != right_->count() || left_->count() > most_branches) {
      return std::nullopt;
    }
    Table<PointIndex, bool> taken(right_->count(), false);
    OneByOne result;
    for (const PointIndex point : left_->points.keys()) {
      const auto to = branches_.continued({left_, point}, right_->parameter);
      if (!to || taken[to->point]) {
        return std::nullopt;
      }
      taken[to->point] = true;
      result.to_right.add(to->point);
    }
    for (const PointIndex point : left_->points.keys()) {
      const BranchPoint from{left_, point};
      const BranchPoint to{right_, result.to_right[point]};
      if (is_turned(from, to)) {
        auto found = passing(branches_, from, to);
        if (!found) {
          return std::nullopt;
        }
        add(point, std::move(*found));
      }
    }
    for (const Meeting& meeting : meetings_) {
      if (!is_smooth(meeting)) {
        return std::nullopt;
      }
      if (meeting.points.size() > 1) {
        result.crossings.push_back(crossing(meeting));
      }
    }
    std::ranges::sort(result.crossings, {},
                      [sense = right_->parameter - left_->parameter](const SingularEvent& event) {
                        return std::copysign(1.0, sense) * event.parameter;
                      });
    return result;
  }

 private:
  void add(PointIndex point, SmoothPassing passing) {
    constexpr double close = 1e-5;
    auto meeting = std::ranges::find_if(meetings_, [&](const Meeting& one) {
      return (one.passings.front().place - passing.place).norm() < close;
    });
    if (meeting == meetings_.end()) {
      meeting = meetings_.insert(meeting, Meeting{});
    }
    meeting->points.push_back(point);
    meeting->passings.push_back(std::move(passing));
  }

  /// Whether branches cross smoothly at a meeting. Rounding of a length opens a crossing further on
  /// a faster branch; and at a crossing there is one configuration, not two beside it or none.
  [[nodiscard]] bool is_smooth(const Meeting& meeting) {
    double slowest = std::numeric_limits<double>::infinity();
    for (const SmoothPassing& passing : meeting.passings) {
      slowest = std::min(slowest, passing.slope.norm());
    }
    const auto is_open = [slowest](const SmoothPassing& passing) {
      return passing.opening >= crossing_limit * std::pow(passing.slope.norm() / slowest, 2);
    };
    return std::ranges::none_of(meeting.passings, is_open) &&
           (meeting.points.size() == 1 ||
            is_one(*branches_.solver().at(meeting.best().location.parameter),
                   meeting.best().place));
  }

  [[nodiscard]] static SingularEvent crossing(const Meeting& meeting) {
    const EventLocation& location = meeting.best().location;
    constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
    double uncertainty = rounding * std::abs(location.parameter);
    for (const SmoothPassing& passing : meeting.passings) {
      uncertainty =
          std::max(uncertainty, std::abs(passing.location.parameter - location.parameter));
    }
    return {EventKind::crossing, location.parameter,     meeting.points, {},
            PointIndex(),        location.configuration, uncertainty};
  }

  LoneBranches branches_;
  const SnapshotPointer& left_;
  const SnapshotPointer& right_;
  std::vector<Meeting> meetings_;
};

}  // namespace

std::optional<OneByOne> explained_one_by_one(SnapshotSolver& solver, const SnapshotPointer& left,
                                             const SnapshotPointer& right) {
  return Follower(solver, left, right).run();
}

}  // namespace assur::mechanism::follow
