// Turns the complete sets of configurations at two parameter values into pairs on the same branch.
#pragma once

#include <vector>

#include "snapshot.hpp"

namespace assur::mechanism::follow {

/// Two matched configurations of the left set whose branches come too close to each other in
/// between to be told apart.
struct TouchingPair {
  PointIndex one, other;
};

/// Which configuration continues which across an interval.
struct BranchMatching {
  Table<PointIndex, PointIndex> to_right;           ///< of each configuration on the left, or none
  std::vector<PointIndex> left_alone, right_alone;  ///< without a match that can be accepted
  std::vector<TouchingPair> touching;
  /// Matched configurations of the left set with a group whose determinant has another sign on the
  /// right: however straight the match, it goes through a singular configuration.
  std::vector<PointIndex> turned;

  /// Whether every branch goes through, none comes near another, and none is singular on its way.
  [[nodiscard]] bool clear() const {
    return left_alone.empty() && right_alone.empty() && touching.empty() && turned.empty();
  }
};

/// For a configuration (X, X') on the left and (Y, Y') on the right of an interval h, the defect
/// |Y - X - h (X' + Y') / 2| vanishes to third order on a branch, and the turn h |Y' - X'| to
/// second. Two are matched if their turn + defect is the least of all, seen from both sides. The
/// defect alone would not tell two branches that cross half-way from two that turn back there. A
/// match is accepted where turn + defect is small, and less than the distance between the cubics
/// through the values and derivatives of this match and any other, throughout the interval.
[[nodiscard]] BranchMatching match(const Snapshot& left, const Snapshot& right);

/// Whether the only configuration of one set goes on to the only one of another, so far from all
/// others at both ends that no other can: see `match`.
[[nodiscard]] bool goes_on(const Snapshot& left, const Snapshot& right);

/// How far from where the tangent leads after a step others need not be known for `goes_on`, there
/// and for a next step of twice the length.
[[nodiscard]] double distance_that_matters(const ConfigurationPoint& from, double step);

/// The cubic with the values and derivatives of `left` and `right`, at a part of the interval.
[[nodiscard]] Eigen::VectorXd cubic(const ConfigurationPoint& left, const ConfigurationPoint& right,
                                    double step, double part);

/// |Y - X - h (X' + Y') / 2|.
[[nodiscard]] double defect(const ConfigurationPoint& left, const ConfigurationPoint& right,
                            double step);

}  // namespace assur::mechanism::follow
