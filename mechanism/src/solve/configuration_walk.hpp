// Depth-first search through the configurations of a mechanism, group by group.
#pragma once

#include <array>
#include <assur/mechanism/solution.hpp>

#include "closing_gaps.hpp"
#include "family_search.hpp"
#include "found_configurations.hpp"
#include "group_order.hpp"
#include "nearness.hpp"
#include "placement.hpp"
#include "redundant_joints.hpp"
#include "search_options.hpp"
#include "watched_limits.hpp"

namespace assur::mechanism::solve {

/// Visits the configurations depth first: a placed group keeps its position while the groups behind
/// it are solved, and its next configuration overwrites it.
class ConfigurationWalk {
 public:
  /// The values must outlive the walk, and stay where they are.
  explicit ConfigurationWalk(const Values& values);

  /// Solves the groups as far as the search requires, and writes the solution. Throws as
  /// `MechanismSolver::solve` does.
  [[nodiscard]] Answer walk(const SearchOptions& search, const Sought& sought, Solution& result);

  [[nodiscard]] TurnCount& turns() { return placement_.turns(); }

 private:
  using Squares = std::array<double, models::most_configurations>;

  void begin(const SearchOptions& search, std::size_t number, Solution& result);
  void descend(std::size_t depth);
  void descend_on(std::size_t depth);
  [[nodiscard]] Visits order_of_visits(GroupIndex group, std::size_t count, Squares& squares);

  Placement placement_;
  PlacedLinks& placed_;  ///< of the placement
  const Structure& structure_;
  const Values& values_;
  ClosingGaps gaps_;
  FamilySearch families_;
  Nearness nearness_;
  GroupOrder group_order_;
  WatchedLimits limits_;
  WatchedRedundancy watched_;
  FoundConfigurations found_;
  /// Where a mechanism may have more configurations than can be listed, they are numbered in the
  /// order of the walk, so that the first ones are found without the others.
  bool is_ordered_by_groups_;
  bool cuts_ = false;                 ///< abandons a configuration once it is beyond limits
  bool has_cut_ = false;              ///< whether one was abandoned beyond limits
  bool leaves_inconsistent_ = false;  ///< abandons it once a redundant joint cannot hold
  bool has_left_inconsistent_ = false;
};

}  // namespace assur::mechanism::solve
