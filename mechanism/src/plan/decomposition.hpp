// Turns a linkage with placed links into its Assur groups, in the order in which they are solved.
#pragma once

#include <assur/mechanism/structure.hpp>
#include <string>
#include <vector>

namespace assur::mechanism::plan {

/// The links of one Assur group, with those between which drivers move, and all their joints
/// without drivers, among themselves and to links placed before. A link that a driver alone places
/// is one without joints.
struct Component {
  std::vector<LinkIndex> links;              ///< ascending
  std::vector<ElementaryJointIndex> joints;  ///< of `Decomposition::linkage`
};

/// Links that the joints do not hold, hold too often, or hold in a circle.
struct Imbalance {
  int surplus = 0;  ///< freedoms, or constraints, that are left over
  std::vector<std::string> links;
  std::vector<std::string> joints;
};

/// What drivers make of the links.
struct DrivenBodies {
  Table<LinkIndex, bool> placed;             ///< the ground, and what it carries
  Table<LinkIndex, LinkIndex> carrier;       ///< of links that drivers tie together, one; or itself
  Table<ElementaryJointIndex, bool> driven;  ///< joints that carry drivers constrain nothing more
  /// For each joint with a driver the links that its law reads.
  Table<ElementaryJointIndex, std::vector<LinkIndex>> read;
};

struct Decomposition {
  Linkage linkage;  ///< with every pin of several links as joints of two
  std::vector<Component> components;
  Imbalance free;        ///< the under-constrained part
  Imbalance overloaded;  ///< the over-constrained part
  /// Links that wait for one another through what the laws of drivers read, and the joints of these
  /// drivers; if there are any, nothing is decomposed.
  Imbalance coupled;
};

/// Matches the freedoms of the unplaced links (three each, and two for the point of a pin of
/// several links) with the constraints of the joints (two each); links that drivers tie together
/// count as one. Where the maximum matching leaves some over, the parts that alternating paths
/// reach are the under- and over-constrained parts (Dulmage-Mendelsohn). Otherwise all links are
/// matched once more, one by one, a joint with a driver making three constraints. A link depends on
/// what its matched joints join it to, and the strongly connected components of that relation are
/// the groups: no smaller part can be solved alone. They come in an order in which each depends on
/// earlier ones only, and the laws of its drivers read earlier ones only; smaller groups first,
/// and then in the order of their links' names.
[[nodiscard]] Decomposition decompose(const Linkage& linkage, const DrivenBodies& bodies);

}  // namespace assur::mechanism::plan
