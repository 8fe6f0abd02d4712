#include "scene/branch_matching.hpp"

#include <algorithm>
#include <limits>

namespace assur::generator {

namespace {

/// Turn + defect of a match may not exceed this, against one plus the size of the point: a branch
/// that runs to infinity is followed at the scale where it is. It bounds how wide an S of two folds
/// on one branch can be and yet be taken for a straight piece.
constexpr double longest_bend = 0.01;

std::size_t slot(int index) { return static_cast<std::size_t>(index); }

/// The cubic with the values and derivatives of `left` and `right`, at a part of the interval.
Eigen::VectorXd cubic(const ConfigurationPoint& left, const ConfigurationPoint& right, double step,
                      double part) {
  const double rest = 1 - part;
  return rest * rest * (1 + 2 * part) * left.at + part * part * (1 + 2 * rest) * right.at +
         step * part * rest * (rest * left.slope - part * right.slope);
}

/// Distance of the origin from the segment between two points.
double distance_to_segment(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
  const Eigen::VectorXd along = to - from;
  const double length = along.squaredNorm();
  const double part = length > 0 ? std::clamp(-from.dot(along) / length, 0.0, 1.0) : 0.0;
  return (from + part * along).norm();
}

class Matcher {
 public:
  Matcher(const Snapshot& left, const Snapshot& right)
      : left_(left), right_(right), step_(right.parameter - left.parameter) {}

  BranchMatching run() {
    pair_up();
    drop_bent_pairs();
    list_alone();
    for (std::size_t one = 0; one < left_.count(); ++one) {
      for (std::size_t other = 0; other < one; ++other) {
        const bool both = result_.to_right[one] >= 0 && result_.to_right[other] >= 0;
        if (both && !(clearance(one, other) > bend(one) + bend(other))) {
          result_.touching.push_back({static_cast<int>(other), static_cast<int>(one)});
        }
      }
    }
    return std::move(result_);
  }

 private:
  void pair_up() {
    const auto rows = static_cast<Eigen::Index>(left_.count());
    const auto columns = static_cast<Eigen::Index>(right_.count());
    Eigen::MatrixXd defects(rows, columns);
    for (Eigen::Index row = 0; row < rows; ++row) {
      for (Eigen::Index column = 0; column < columns; ++column) {
        defects(row, column) = defect(left_.points[static_cast<std::size_t>(row)],
                                      right_.points[static_cast<std::size_t>(column)], step_);
      }
    }
    result_.to_right.assign(left_.count(), -1);
    for (Eigen::Index row = 0; row < rows && columns > 0; ++row) {
      Eigen::Index best = 0;
      Eigen::Index back = 0;
      defects.row(row).minCoeff(&best);
      defects.col(best).minCoeff(&back);
      if (back == row) {
        result_.to_right[static_cast<std::size_t>(row)] = static_cast<int>(best);
      }
    }
  }

  void drop_bent_pairs() {
    for (std::size_t index = 0; index < left_.count(); ++index) {
      int& to = result_.to_right[index];
      if (to >= 0 && !(bend(index) <= longest_bend * (1 + size_of(index)))) {
        to = -1;
      }
    }
  }

  void list_alone() {
    std::vector<bool> taken(right_.count(), false);
    for (std::size_t index = 0; index < left_.count(); ++index) {
      if (result_.to_right[index] < 0) {
        result_.left_alone.push_back(static_cast<int>(index));
      } else {
        taken[slot(result_.to_right[index])] = true;
      }
    }
    for (std::size_t index = 0; index < right_.count(); ++index) {
      if (!taken[index]) {
        result_.right_alone.push_back(static_cast<int>(index));
      }
    }
  }

  [[nodiscard]] const ConfigurationPoint& matched(std::size_t index) const {
    return right_.points[slot(result_.to_right[index])];
  }
  [[nodiscard]] double size_of(std::size_t index) const {
    return std::max(left_.points[index].at.norm(), matched(index).at.norm());
  }
  /// How far a branch may stray from its cubic: turn + defect.
  [[nodiscard]] double bend(std::size_t index) const {
    const ConfigurationPoint& from = left_.points[index];
    const ConfigurationPoint& to = matched(index);
    return std::abs(step_) * (to.slope - from.slope).norm() + defect(from, to, step_);
  }

  /// Least distance between the cubics of two matches, each difference taken as straight between
  /// quarters of the interval.
  [[nodiscard]] double clearance(std::size_t one, std::size_t other) const {
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

double defect(const ConfigurationPoint& left, const ConfigurationPoint& right, double step) {
  return (right.at - left.at - step / 2 * (left.slope + right.slope)).norm();
}

BranchMatching match(const Snapshot& left, const Snapshot& right) {
  return Matcher(left, right).run();
}

}  // namespace assur::generator
