// Tests of joints' limits during a search, each as soon as its joint is placed.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <optional>
#include <string>
#include <vector>

#include "placement.hpp"

namespace assur::mechanism::solve {

/// The joints with limits, sorted by the number of groups that must be placed before each has its
/// coordinate.
class WatchedLimits {
 public:
  /// The placement must outlive it.
  explicit WatchedLimits(const Placement& placement);

  [[nodiscard]] bool exist() const { return exist_; }
  /// Whether the joints that get their coordinates once `groups` groups are placed keep their
  /// limits; violations are added to `breaches`.
  [[nodiscard]] bool are_kept_at(std::size_t groups, std::vector<LimitBreach>& breaches) const;
  /// Whether all joints keep their limits, once everything is placed.
  [[nodiscard]] bool are_kept(std::vector<LimitBreach>& breaches) const;
  /// Keeps the placed configuration if it is nearer to the limits than the one kept so far.
  void keep_nearest(std::optional<NearestToLimits>& nearest) const;

 private:
  const Placement& placement_;
  std::vector<std::vector<JointIndex>> joints_;  ///< by the number of groups before them
  bool exist_ = false;

  /// The sum of squares of excesses, angles in radians and lengths relative to the mechanism's
  /// size.
  [[nodiscard]] double square_of(const std::vector<NearestToLimits::Excess>& excesses) const;
};

/// One sentence that says that all `count` configurations are beyond limits, with their breaches.
[[nodiscard]] std::string reason_of_limits(std::size_t count, const std::string& breaches);

}  // namespace assur::mechanism::solve
