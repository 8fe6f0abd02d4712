// Turns limits of joints into what is tested while groups are placed, as soon as a joint is.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <string>
#include <vector>

#include "placement.hpp"

namespace assur::mechanism::solve {

/// The joints with limits, by how many groups are placed before each has its coordinate.
class WatchedLimits {
 public:
  /// The placement must outlive it.
  explicit WatchedLimits(const Placement& placement);

  [[nodiscard]] bool exist() const { return exist_; }
  /// Of the joints that have their coordinates after so many groups; each that is beyond its limits
  /// is told.
  [[nodiscard]] bool are_kept_at(std::size_t groups, std::vector<LimitBreach>& breaches) const;
  /// Of all joints, where everything is placed.
  [[nodiscard]] bool are_kept(std::vector<LimitBreach>& breaches) const;

 private:
  const Placement& placement_;
  std::vector<std::vector<JointIndex>> joints_;  ///< by the groups before them
  bool exist_ = false;
};

/// What is said of so many configurations that are all beyond limits, by some breaches.
[[nodiscard]] std::string reason_of_limits(std::size_t count, const std::string& breaches);

}  // namespace assur::mechanism::solve
