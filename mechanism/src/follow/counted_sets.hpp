// Sets of configurations from which whole turns are counted along a sweep.
#pragma once

#include <vector>

#include "snapshot.hpp"
#include "solve/nearby_configurations.hpp"

namespace assur::mechanism::follow {

/// Whether a law reads an angle in some configuration, so that whole turns are counted.
[[nodiscard]] bool has_counted_angles(const Snapshot& snapshot);

/// The set of the last step, and sets between steps on the way to others. Empty if laws read no
/// angles.
class CountedSets {
 public:
  /// `reads_angles`: whether laws read angles. `column`: the column of the derivatives with respect
  /// to the swept parameter.
  CountedSets(bool reads_angles, Eigen::Index column)
      : reads_angles_(reads_angles), column_(column) {}

  [[nodiscard]] bool is_empty() const { return sets_.empty(); }
  /// The set with the nearest value of the parameter; there must be one.
  [[nodiscard]] const SnapshotPointer& nearest(double parameter) const;
  /// Keeps a set if turns are known in it: one with angles that laws read, or an empty one, since
  /// branches that begin after a gap begin to count. In a degenerate set, branches continue unseen;
  /// where they meet, or the count `is_ambiguous`, it is unknown which of them a configuration
  /// continues, or whether the law has a value there.
  void note(const SnapshotPointer& set, bool is_ambiguous);
  /// From now on, turns are counted from this set alone.
  void forget_all_but(const SnapshotPointer& set) { sets_ = std::vector{set}; }
  /// The same, if laws read angles in the set.
  void count_from(const SnapshotPointer& set);
  /// The nearest sets on both sides of a value, from which its turns are counted: branches that end
  /// between them are known on one side only. Those of the set at `from` should continue.
  [[nodiscard]] std::vector<solve::NearbyConfigurations> beside(double parameter,
                                                                double from) const;

 private:
  bool reads_angles_;
  Eigen::Index column_;
  std::vector<SnapshotPointer> sets_;
};

}  // namespace assur::mechanism::follow
