#include "branch_matching.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace assur::mechanism::follow {

namespace {

/// The largest turn + defect of a match, relative to one plus the size of the point, so that a
/// branch that runs to infinity is followed at its own scale. It bounds the width of an S of two
/// folds that passes for a straight piece of one branch.
constexpr double longest_bend = 0.01;

/// The least distance of others from a branch, relative to its length and bend.
constexpr double clear_of_others = 3;

/// The rows of one link in a point.
constexpr int rows_of_link = 4;

/// The distance of the origin from the segment between two points.
double distance_to_segment(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
  const Eigen::VectorXd along = to - from;
  const double length = along.squaredNorm();
  const double part = length > 0 ? std::clamp(-from.dot(along) / length, 0.0, 1.0) : 0.0;
  return (from + part * along).norm();
}

/// Whether a sum of vectors of configurations is longer than a limit. `part` gives its piece of one
/// link, from a row on; links after the one that decides are not evaluated.
template <typename Part>
bool is_longer(Eigen::Index size, double limit, const Part& part) {
  double square = 0;
  for (Eigen::Index row = 0; row < size && square <= limit * limit; row += rows_of_link) {
    square += part(row).squaredNorm();
  }
  return square > limit * limit;
}

class Matcher {
 public:
  Matcher(const Snapshot& left, const Snapshot& right)
      : left_(left), right_(right), step_(right.parameter - left.parameter) {}

  BranchMatching run() {
    result_.to_right.assign(left_.count(), PointIndex());
    if (stay_apart()) {
      for (const PointIndex point : left_.points.keys()) {
        result_.to_right[point] = point;
      }
    } else {
      pair_up();
      list_alone();
      list_touching();
    }
    list_turned();
    return std::move(result_);
  }

  /// Whether all points stay apart, and none goes through a singular configuration.
  [[nodiscard]] bool is_plain() {
    result_.to_right.assign(left_.count(), PointIndex(0));
    list_turned();
    return stay_apart() && result_.turned.empty();
  }

 private:
  /// Whether each point's match is the one with the same index and no two branches come near,
  /// because the points are so far apart that other pairs need no test. Let every point move by r
  /// at most and bend by b. Then h times a slope is r + b at most, the defect of any other pair is
  /// the least distance of two points less 2 r + b at least, and the cubics stay as far apart as
  /// `is_far` requires where that distance exceeds 3 (r + b).
  [[nodiscard]] bool stay_apart() const {
    if (left_.count() != right_.count()) {
      return false;
    }
    double reach = 0;
    double most_bent = 0;
    for (const PointIndex point : left_.points.keys()) {
      const ConfigurationPoint& from = left_.points[point];
      const ConfigurationPoint& to = right_.points[point];
      const double bent = bend(from, to);
      if (!(bent <= longest_bend)) {
        return false;
      }
      most_bent = std::max(most_bent, bent);
      reach = std::max(reach, (to.at - from.at).norm());
    }
    return left_.closest > clear_of_others * (reach + most_bent);
  }

  void pair_up() {
    if (left_.count() == 0 || right_.count() == 0) {
      return;
    }
    // If two branches that cross halfway turned back there, they would have no defect either. The
    // turn shows that they go straight on.
    Eigen::MatrixXd bends = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(left_.count()),
                                                      static_cast<Eigen::Index>(right_.count()),
                                                      std::numeric_limits<double>::infinity());
    const Table<PointIndex, double> left_sizes = sizes_of(left_);
    const Table<PointIndex, double> right_sizes = sizes_of(right_);
    const double largest = std::ranges::max(right_sizes);
    // The defect is the distance of these.
    const auto onward = [&](PointIndex point) -> Eigen::VectorXd {
      return left_.points[point].at + step_ / 2 * left_.points[point].slope;
    };
    const OrderOnLine order(right_.count(), [&](PointIndex point) -> Eigen::VectorXd {
      return right_.points[point].at - step_ / 2 * right_.points[point].slope;
    });
    for (const PointIndex from : left_.points.keys()) {
      const double farthest = longest_bend * (1 + std::max(left_sizes[from], largest));
      for (const auto& [place, to] : order.within(farthest, OrderOnLine::place_of(onward(from)))) {
        const double most = longest_bend * (1 + std::max(left_sizes[from], right_sizes[to]));
        bends(from.row(), to.row()) = bend_up_to(most, left_.points[from], right_.points[to]);
      }
    }
    for (const PointIndex from : left_.points.keys()) {
      Eigen::Index best = 0;
      Eigen::Index back = 0;
      const double least = bends.row(from.row()).minCoeff(&best);
      bends.col(best).minCoeff(&back);
      if (std::isfinite(least) && back == from.row()) {
        result_.to_right[from] = PointIndex(static_cast<std::size_t>(best));
      }
    }
  }

  void list_alone() {
    Table<PointIndex, bool> taken(right_.count(), false);
    for (const PointIndex point : left_.points.keys()) {
      if (result_.to_right[point].exists()) {
        taken[result_.to_right[point]] = true;
      } else {
        result_.left_alone.push_back(point);
      }
    }
    for (const PointIndex point : right_.points.keys()) {
      if (!taken[point]) {
        result_.right_alone.push_back(point);
      }
    }
  }

  void list_touching() {
    Table<PointIndex, double> bends(left_.count(), 0.0);
    Table<PointIndex, double> reaches(left_.count(), 0.0);  // how far a match may leave its point
    double farthest = 0;
    for (const PointIndex point : left_.points.keys()) {
      if (result_.to_right[point].exists()) {
        bends[point] = bend(point);
        reaches[point] = bends[point] + stray(point);
        farthest = std::max(farthest, reaches[point]);
      }
    }
    const OrderOnLine order(left_.count(),
                            [&](PointIndex point) { return left_.points[point].at; });
    for (const auto& [place, one] : order.places()) {
      if (!result_.to_right[one].exists()) {
        continue;
      }
      for (const auto& [other_place, other] : order.within(reaches[one] + farthest, place)) {
        if (other < one && result_.to_right[other].exists() &&
            !is_apart(one, other, reaches[one] + reaches[other]) &&
            !is_far(one, other, bends[one] + bends[other]) &&
            !(clearance(one, other) > bends[one] + bends[other])) {
          result_.touching.push_back({other, one});
        }
      }
    }
    std::ranges::sort(result_.touching, [](const TouchingPair& a, const TouchingPair& b) {
      return std::pair(a.other, a.one) < std::pair(b.other, b.one);
    });
  }

  void list_turned() {
    for (const PointIndex point : left_.points.keys()) {
      if (result_.to_right[point].exists() && is_turned(point)) {
        result_.turned.push_back(point);
      }
    }
  }

  [[nodiscard]] bool is_turned(PointIndex point) const {
    const auto& before = left_.configuration(point).determinants;
    const auto& after = right_.configuration(result_.to_right[point]).determinants;
    // NOLINTNEXTLINE(readability-use-anyofallof): the keys of a table are no standard range
    for (const GroupIndex group : before.keys()) {
      if (left_.roles[group] == right_.roles[group] && std::min(before[group], after[group]) < 0 &&
          std::max(before[group], after[group]) > 0) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] const ConfigurationPoint& matched(PointIndex index) const {
    return right_.points[result_.to_right[index]];
  }
  /// Bound on the deviation of a branch from its cubic: turn + defect.
  [[nodiscard]] double bend(PointIndex index) const {
    return bend(left_.points[index], matched(index));
  }
  [[nodiscard]] double bend(const ConfigurationPoint& from, const ConfigurationPoint& to) const {
    return std::abs(step_) * (to.slope - from.slope).norm() + defect(from, to, step_);
  }

  /// The same, or infinity if it exceeds a limit.
  [[nodiscard]] double bend_up_to(double most, const ConfigurationPoint& from,
                                  const ConfigurationPoint& to) const {
    const auto defect_of_link = [&](Eigen::Index row) {
      const auto of = [row](const Eigen::VectorXd& all) { return all.segment<rows_of_link>(row); };
      return (of(to.at) - of(from.at) - step_ / 2 * (of(from.slope) + of(to.slope))).eval();
    };
    if (is_longer(from.at.size(), most, defect_of_link)) {
      return std::numeric_limits<double>::infinity();
    }
    const double bent = bend(from, to);
    return bent <= most ? bent : std::numeric_limits<double>::infinity();
  }

  [[nodiscard]] static Table<PointIndex, double> sizes_of(const Snapshot& set) {
    Table<PointIndex, double> sizes(set.count(), 0.0);
    for (const PointIndex point : set.points.keys()) {
      sizes[point] = set.points[point].at.norm();
    }
    return sizes;
  }

  /// The deviation of a match's cubic from its start: see `is_far`.
  [[nodiscard]] double stray(PointIndex index) const {
    const ConfigurationPoint& from = left_.points[index];
    const ConfigurationPoint& to = matched(index);
    return (to.at - from.at).norm() +
           4.0 / 27 * std::abs(step_) * (from.slope.norm() + to.slope.norm());
  }

  /// Whether two points of the left set are further apart than a distance.
  [[nodiscard]] bool is_apart(PointIndex one, PointIndex other, double distance) const {
    return is_longer(left_.points[one].at.size(), distance, [&](Eigen::Index row) {
      return (left_.points[one].at.segment<rows_of_link>(row) -
              left_.points[other].at.segment<rows_of_link>(row))
          .eval();
    });
  }

  /// Whether the cubics of two matches stay so far apart that no samples are needed: they are far
  /// apart at both ends, and in between a difference D of cubics with slopes s deviates from its
  /// first value by at most |D1 - D0| + 4/27 h (|s0| + |s1|).
  [[nodiscard]] bool is_far(PointIndex one, PointIndex other, double limit) const {
    const ConfigurationPoint& from = left_.points[one];
    const ConfigurationPoint& other_from = left_.points[other];
    const ConfigurationPoint& to = matched(one);
    const ConfigurationPoint& other_to = matched(other);
    const double move = (to.at - other_to.at - from.at + other_from.at).norm();
    const double slopes =
        (from.slope - other_from.slope).norm() + (to.slope - other_to.slope).norm();
    return (from.at - other_from.at).norm() - move - 4.0 / 27 * std::abs(step_) * slopes > limit;
  }

  /// The least distance between the cubics of two matches, with their difference taken as straight
  /// between quarters of the interval.
  [[nodiscard]] double clearance(PointIndex one, PointIndex other) const {
    constexpr int parts = 4;
    const auto apart = [&](int part) -> Eigen::VectorXd {
      const double place = static_cast<double>(part) / parts;
      return cubic(left_.points[one], matched(one), step_, place) -
             cubic(left_.points[other], matched(other), step_, place);
    };
    double least = std::numeric_limits<double>::infinity();
    for (int part = 0; part < parts; ++part) {
      least = std::min(least, distance_to_segment(apart(part), apart(part + 1)));
    }
    return least;
  }

  const Snapshot& left_;
  const Snapshot& right_;
  double step_;
  BranchMatching result_;
};

}  // namespace

Eigen::VectorXd cubic(const ConfigurationPoint& left, const ConfigurationPoint& right, double step,
                      double part) {
  const double rest = 1 - part;
  return rest * rest * (1 + 2 * part) * left.at + part * part * (1 + 2 * rest) * right.at +
         step * part * rest * (rest * left.slope - part * right.slope);
}

double defect(const ConfigurationPoint& left, const ConfigurationPoint& right, double step) {
  return (right.at - left.at - step / 2 * (left.slope + right.slope)).norm();
}

bool goes_on(const Snapshot& left, const Snapshot& right) {
  return left.count() == 1 && right.count() == 1 && Matcher(left, right).is_plain() &&
         Matcher(right, left).is_plain();
}

// The branch moves by |h slope| + b, and b off its tangent; the next step may be twice as long.
double distance_that_matters(const ConfigurationPoint& from, double step) {
  const double way = 2 * std::abs(step) * from.slope.norm();
  return clear_of_others * (way + 2 * longest_bend) + longest_bend;
}

BranchMatching match(const Snapshot& left, const Snapshot& right) {
  return Matcher(left, right).run();
}

}  // namespace assur::mechanism::follow
