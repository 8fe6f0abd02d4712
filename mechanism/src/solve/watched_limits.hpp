// Turns limits of joints into tests that run while groups are placed, each as soon as its joint is.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <optional>
#include <string>
#include <vector>

#include "placement.hpp"

namespace assur::mechanism::solve {

/// The joints with limits, sorted by how many groups must be placed before each has its coordinate.
class WatchedLimits {
 public:
  /// The placement must outlive it.
  explicit WatchedLimits(const Placement& placement);

  [[nodiscard]] bool exist() const { return exist_; }
  /// Whether the joints that get their coordinates once `groups` groups are placed keep their
  /// limits; those that do not are added to `breaches`.
  [[nodiscard]] bool are_kept_at(std::size_t groups, std::vector<LimitBreach>& breaches) const;
  /// Whether all joints keep their limits, once everything is placed.
  [[nodiscard]] bool are_kept(std::vector<LimitBreach>& breaches) const;
  /// Keeps the placed configuration if it is nearer to the limits than the one that is kept.
  void keep_nearest(std::optional<NearestToLimits>& nearest) const;

 private:
  const Placement& placement_;
  std::vector<std::vector<JointIndex>> joints_;  ///< by the groups before them
  bool exist_ = false;

  /// The sum of squares of excesses, angles in radians and lengths in parts of the mechanism's.
  [[nodiscard]] double square_of(const std::vector<NearestToLimits::Excess>& excesses) const;
};

/// One sentence for `count` configurations that are all beyond limits, with their breaches.
[[nodiscard]] std::string reason_of_limits(std::size_t count, const std::string& breaches);

}  // namespace assur::mechanism::solve
