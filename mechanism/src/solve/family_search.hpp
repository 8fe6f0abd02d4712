// Turns a group that moves, or fails, where it is held into the families that are listed for it.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <string>
#include <vector>

#include "closing_gaps.hpp"
#include "placement.hpp"

namespace assur::mechanism::solve {

/// Lists groups that move where they are held, each once for each choice of the groups that hold
/// it. If a group that does not depend on it cannot be assembled, nothing is listed: the answer
/// must not depend on which of the two comes first. Nor may it hide another that moves.
class FamilySearch {
 public:
  /// Both must outlive the search.
  FamilySearch(Placement& placement, ClosingGaps& gaps);

  /// Families are written to `families`; where `one` is enough, no more than one.
  void begin(std::vector<Family>& families, bool one);
  /// A group that is held has `mobility`, for a reason. All groups behind it are asked; what is
  /// placed is left as it is. Throws MechanismError for too many families.
  void add(GroupIndex group, int mobility, std::string reason);

 private:
  using Unplaced = Table<LinkIndex, bool>;

  void add(GroupIndex group, int mobility, std::string reason, Unplaced unplaced);
  void leave_out(GroupIndex group, Unplaced& unplaced) const;
  /// Adds the groups from `depth` on that move, whatever becomes of the links left unplaced.
  void find_behind(std::size_t depth, Unplaced unplaced);
  /// Whether the groups from `depth` on can be assembled together. Groups that `unplaced` links
  /// hold are left out, and so are groups that move.
  [[nodiscard]] bool rest_assembles(std::size_t depth, Unplaced unplaced);
  /// Whether the group's family is listed with the same links where they are now: the choices of
  /// groups that do not hold it make no other family of it. As of configurations, what differs by
  /// rounding is the same.
  [[nodiscard]] bool is_listed(const Family& family) const;

  Placement& placement_;
  ClosingGaps& gaps_;
  const Structure& structure_;
  std::vector<Family>* families_ = nullptr;
  bool one_is_enough_ = false;
};

}  // namespace assur::mechanism::solve
