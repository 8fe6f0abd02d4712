// Tests of whether redundant joints hold between placed links.
#pragma once

#include <assur/mechanism/frame.hpp>
#include <assur/mechanism/values.hpp>
#include <assur/status.hpp>
#include <vector>

namespace assur::mechanism::solve {

/// Whether the redundant joints of a plan hold to first order up to rounding, where all rates are
/// known. In a regular configuration with accurate second rates, they must also hold to second
/// order.
[[nodiscard]] bool goes_on_redundantly(const Values& values, const Table<LinkIndex, Frame>& links,
                                       Status regularity);

/// The distance by which the worst redundant joint fails to close, in the scene's unit; zero if all
/// close up to rounding or the tolerance of the request.
[[nodiscard]] double gap_of_redundant(const Values& values, const Table<LinkIndex, Frame>& links,
                                      Status regularity);

/// The redundant joints of a plan as tests during a search, each as soon as both links of the joint
/// are placed.
class WatchedRedundancy {
 public:
  /// The values must outlive it.
  explicit WatchedRedundancy(const Values& values);

  /// Whether the redundant joints whose links are placed once `groups` groups are may hold. These
  /// groups must be regular; the tolerance is the wider one, of singular groups.
  [[nodiscard]] bool may_hold_at(std::size_t groups, const Table<LinkIndex, Frame>& links) const;

 private:
  const Values& values_;
  Table<LinkIndex, std::size_t> before_;  ///< the number of groups that each link needs
  std::vector<std::vector<const RedundantJoint*>> joints_;  ///< by number of groups needed
};

}  // namespace assur::mechanism::solve
