// Assignment of rows to branches at steps whose configurations cannot be distinguished.
#pragma once

#include <vector>

#include "snapshot.hpp"

namespace assur::mechanism::follow {

/// One end of an interval: a set that can be followed, and the numbers of its branches.
struct IntervalEnd {
  SnapshotPointer set;
  Table<PointIndex, int> branches;  ///< 0 for those that are not reported
};

/// A row of a step: a configuration, with its rates on one branch.
struct StepRow {
  PointIndex point;
  int branch;  ///< 0 if it belongs to none
  const Configuration* state;
};

/// An interval within which sets of configurations are not followed. The rows of its steps are
/// assigned to the branches that lead into it and out of it.
class UnfollowedInterval {
 public:
  /// Either end may be missing. `length` is the unit of the points.
  UnfollowedInterval(IntervalEnd before, IntervalEnd after, double length);
  UnfollowedInterval(const UnfollowedInterval&) = delete;  // the leads point to the ends
  UnfollowedInterval& operator=(const UnfollowedInterval&) = delete;

  /// Whether a value lies inside, in the direction of a sweep.
  [[nodiscard]] bool covers(double parameter, double sense) const {
    return after_.set != nullptr && sense * (after_.set->parameter - parameter) > 0;
  }
  /// Whether there is a set before it, and one after it.
  [[nodiscard]] bool leads_in() const { return before_.set != nullptr; }
  [[nodiscard]] bool leads_on() const { return after_.set != nullptr; }
  /// The numbers of the branches that lead into it, and of those that lead out of it.
  [[nodiscard]] std::vector<int> branches_before() const { return told(before_); }
  [[nodiscard]] std::vector<int> branches_after() const { return told(after_); }
  /// The rows of a step. Each configuration is assigned to the branch with the nearest prediction
  /// that may reach it, first to one that goes through. A singular configuration is then assigned
  /// to all such branches without one, since several may meet in it. Each branch through it has a
  /// row, with its own rates where they are known; otherwise one row has the least of their
  /// numbers.
  [[nodiscard]] std::vector<StepRow> rows(const Snapshot& step) const;
  /// The branches that no configuration of a step is assigned to.
  [[nodiscard]] std::vector<int> branches_without_place(const Snapshot& step) const;

 private:
  [[nodiscard]] static std::vector<int> told(const IntervalEnd& end) {
    std::vector<int> numbers = end.branches.items();
    std::erase(numbers, 0);
    return numbers;
  }
  /// A branch at one end of the interval.
  struct BranchAtEnd {
    int branch;
    const IntervalEnd* from;
    PointIndex point;
    PointIndex later;  ///< at the other end, if the branch goes through
    [[nodiscard]] bool goes_through() const { return later.exists(); }
  };
  [[nodiscard]] Eigen::VectorXd expected(const BranchAtEnd& lead, double parameter) const;
  [[nodiscard]] double reach(const BranchAtEnd& lead, double parameter) const;
  [[nodiscard]] double difference_of_rates(const BranchAtEnd& lead,
                                           const Configuration& state) const;
  [[nodiscard]] Table<PointIndex, std::vector<const BranchAtEnd*>> assigned(
      const Snapshot& step) const;
  void add_rows(const Snapshot& step, PointIndex point, std::vector<const BranchAtEnd*> leads,
                std::vector<StepRow>& rows) const;

  IntervalEnd before_, after_;
  double length_;
  std::vector<BranchAtEnd> leads_;
};

}  // namespace assur::mechanism::follow
