// Families of configurations listed for a group that moves freely or is inconsistent.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <string>
#include <vector>

#include "closing_gaps.hpp"
#include "placement.hpp"

namespace assur::mechanism::solve {

/// Lists the groups that move although they are held, once for each choice of the groups that hold
/// them. If another group, independent of the moving one, cannot be assembled, nothing is listed:
/// the answer must not depend on which of the two comes first. Nor may one moving group hide
/// another.
class FamilySearch {
 public:
  /// Both must outlive the search.
  FamilySearch(Placement& placement, ClosingGaps& gaps);

  /// Families are written to `families`, at most one of them if `one` is set.
  void begin(std::vector<Family>& families, bool one);
  /// Lists the family of a held group that has `mobility`, with a reason, if all groups behind it
  /// allow it. The placed links keep their poses. Throws MechanismError for too many families.
  void add(GroupIndex group, int mobility, std::string reason);

 private:
  using Unplaced = Table<LinkIndex, bool>;

  void add(GroupIndex group, int mobility, std::string reason, Unplaced unplaced);
  void leave_out(GroupIndex group, Unplaced& unplaced) const;
  /// Adds those groups from `depth` on that move for every position of the unplaced links.
  void find_behind(std::size_t depth, Unplaced unplaced);
  /// Whether the groups from `depth` on can be assembled together. Groups held by `unplaced` links
  /// are left out, and so are groups that move or whose closure is in doubt.
  [[nodiscard]] bool rest_assembles(std::size_t depth, Unplaced unplaced);
  /// Whether this family is listed already at the present poses of the links that hold it: the
  /// choices of other groups make no other family. Families that differ by rounding are the same,
  /// as configurations are.
  [[nodiscard]] bool is_listed(const Family& family) const;

  Placement& placement_;
  ClosingGaps& gaps_;
  const Structure& structure_;
  std::vector<Family>* families_ = nullptr;
  bool one_is_enough_ = false;
};

}  // namespace assur::mechanism::solve
