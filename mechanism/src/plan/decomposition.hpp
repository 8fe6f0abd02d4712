// Turns a linkage with placed links into its Assur groups, in the order in which they are solved.
#pragma once

#include <assur/mechanism/structure.hpp>
#include <string>
#include <vector>

namespace assur::mechanism::plan {

/// The links of one Assur group and all their joints, among themselves and to links placed before.
struct Component {
  std::vector<LinkIndex> links;              ///< ascending
  std::vector<ElementaryJointIndex> joints;  ///< of `Decomposition::linkage`
};

/// Links that the joints do not hold, or hold too often.
struct Imbalance {
  int surplus = 0;  ///< freedoms, or constraints, that are left over
  std::vector<std::string> links;
  std::vector<std::string> joints;
};

struct Decomposition {
  Linkage linkage;  ///< with every pin of several links as joints of two
  std::vector<Component> components;
  Imbalance free;        ///< the under-constrained part
  Imbalance overloaded;  ///< the over-constrained part
};

/// Matches the freedoms of the unplaced links (three each, and two for the point of a pin of
/// several links) with the constraints of the joints (two each). Where the maximum matching leaves
/// some over, the parts that alternating paths reach are the under- and over-constrained parts
/// (Dulmage-Mendelsohn). Otherwise a link depends on what its matched joints join it to, and the
/// strongly connected components of that relation are the groups: no smaller part can be solved
/// alone. They come in an order in which each depends on earlier ones only, smaller groups first.
/// `spent` joints carry drivers and constrain nothing more.
[[nodiscard]] Decomposition decompose(const Linkage& linkage, const Table<LinkIndex, bool>& placed,
                                      const Table<ElementaryJointIndex, bool>& spent);

}  // namespace assur::mechanism::plan
