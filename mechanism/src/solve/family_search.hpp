// Turns a group that moves freely or is inconsistent where it is held into the families that are
// listed for it.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <string>
#include <vector>

#include "closing_gaps.hpp"
#include "placement.hpp"

namespace assur::mechanism::solve {

/// Lists groups that move where they are held, each once for each choice of the groups that hold
/// it. If another group, which does not depend on the moving one, cannot be assembled, nothing is
/// listed: the answer must not depend on which of the two comes first. Nor may one moving group
/// hide another.
class FamilySearch {
 public:
  /// Both must outlive the search.
  FamilySearch(Placement& placement, ClosingGaps& gaps);

  /// Families are written to `families`, at most one of them if `one` is set.
  void begin(std::vector<Family>& families, bool one);
  /// Lists the family of a held group that has `mobility`, for a reason, if all groups behind it
  /// allow it. The placed links stay as they are. Throws MechanismError for too many families.
  void add(GroupIndex group, int mobility, std::string reason);

 private:
  using Unplaced = Table<LinkIndex, bool>;

  void add(GroupIndex group, int mobility, std::string reason, Unplaced unplaced);
  void leave_out(GroupIndex group, Unplaced& unplaced) const;
  /// Adds those groups from `depth` on that move, wherever the unplaced links are.
  void find_behind(std::size_t depth, Unplaced unplaced);
  /// Whether the groups from `depth` on can be assembled together. Groups that `unplaced` links
  /// hold are left out, and so are groups that move, or that are not known to close or not.
  [[nodiscard]] bool rest_assembles(std::size_t depth, Unplaced unplaced);
  /// Whether this family is listed already with its holding links where they are now: the choices
  /// of groups that do not hold it make no other family. Families that differ by rounding are the
  /// same, as configurations are.
  [[nodiscard]] bool is_listed(const Family& family) const;

  Placement& placement_;
  ClosingGaps& gaps_;
  const Structure& structure_;
  std::vector<Family>* families_ = nullptr;
  bool one_is_enough_ = false;
};

}  // namespace assur::mechanism::solve
