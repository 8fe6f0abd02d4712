// Matching of the configurations at two parameter values that lie on the same branch.
#pragma once

#include <vector>

#include "snapshot.hpp"

namespace assur::mechanism::follow {

/// Two matched configurations of the left set whose branches come too close to each other within
/// the interval to be distinguished.
struct TouchingPair {
  PointIndex one, other;
};

/// The continuation of configurations across an interval.
struct BranchMatching {
  Table<PointIndex, PointIndex> to_right;           ///< of each configuration on the left, or none
  std::vector<PointIndex> left_alone, right_alone;  ///< without an acceptable match
  std::vector<TouchingPair> touching;
  /// Matched configurations of the left set with a group whose determinant has another sign on the
  /// right: however straight the match, it goes through a singular configuration.
  std::vector<PointIndex> turned;

  /// Whether every branch goes through, none comes near another, and none is singular within the
  /// interval.
  [[nodiscard]] bool clear() const {
    return left_alone.empty() && right_alone.empty() && touching.empty() && turned.empty();
  }
};

/// Two configurations, (X, X') on the left and (Y, Y') on the right of an interval h, have the
/// defect |Y - X - h (X' + Y') / 2|, which vanishes to third order on a branch, and the turn
/// h |Y' - X'|, which vanishes to second. Two are matched if their turn + defect is the least of
/// all, seen from both sides. The defect alone would not distinguish two branches that cross
/// halfway from two that turn back there. A match is accepted where turn + defect is small, and
/// less than the distance between the cubics through the values and derivatives of this match and
/// any other, throughout the interval.
[[nodiscard]] BranchMatching match(const Snapshot& left, const Snapshot& right);

/// Whether the only configuration of one set continues as the only one of another, so far from all
/// others at both ends that no other can: see `match`.
[[nodiscard]] bool goes_on(const Snapshot& left, const Snapshot& right);

/// The distance from the tangent's prediction within which others must be known for `goes_on`, at
/// the end of a step and for a next step of twice the length.
[[nodiscard]] double distance_that_matters(const ConfigurationPoint& from, double step);

/// The cubic with the values and derivatives of `left` and `right`, at a part of the interval.
[[nodiscard]] Eigen::VectorXd cubic(const ConfigurationPoint& left, const ConfigurationPoint& right,
                                    double step, double part);

/// |Y - X - h (X' + Y') / 2|.
[[nodiscard]] double defect(const ConfigurationPoint& left, const ConfigurationPoint& right,
                            double step);

}  // namespace assur::mechanism::follow
