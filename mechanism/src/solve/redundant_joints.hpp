// Turns placed links into whether the redundant joints, beyond those that determine the links,
// hold.
#pragma once

#include <assur/mechanism/frame.hpp>
#include <assur/mechanism/values.hpp>
#include <assur/status.hpp>
#include <vector>

namespace assur::mechanism::solve {

/// Whether the redundant joints of a plan hold to first order up to rounding, where all rates are
/// known. In a regular configuration, whose second rates are accurate enough, they must hold to
/// second order, too.
[[nodiscard]] bool goes_on_redundantly(const Values& values, const Table<LinkIndex, Frame>& links,
                                       Status regularity);

/// The distance by which the worst redundant joint fails to close, in the scene's unit; zero where
/// all close up to rounding or the tolerance that the request states.
[[nodiscard]] double gap_of_redundant(const Values& values, const Table<LinkIndex, Frame>& links,
                                      Status regularity);

/// The redundant joints of a plan as tests that run while groups are placed, each as soon as both
/// links of the joint are.
class WatchedRedundancy {
 public:
  /// The values must outlive it.
  explicit WatchedRedundancy(const Values& values);

  /// Whether the redundant joints whose links are placed once `groups` groups are may hold. These
  /// groups must be regular; the tolerance is the wider one of groups that are not.
  [[nodiscard]] bool may_hold_at(std::size_t groups, const Table<LinkIndex, Frame>& links) const;

 private:
  const Values& values_;
  Table<LinkIndex, std::size_t> before_;                    ///< how many groups each link needs
  std::vector<std::vector<const RedundantJoint*>> joints_;  ///< by the groups that they need
};

}  // namespace assur::mechanism::solve
