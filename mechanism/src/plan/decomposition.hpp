// Turns a linkage with placed links into its Assur groups, in the order in which they are solved.
#pragma once

#include <assur/mechanism/structure.hpp>
#include <string>
#include <vector>

namespace assur::mechanism::plan {

/// The links of one Assur group, with the links that drivers tie to them, and all their joints
/// without drivers, among themselves and to links placed before. A link that only a driver places
/// is a component without joints.
struct Component {
  std::vector<LinkIndex> links;              ///< ascending
  std::vector<ElementaryJointIndex> joints;  ///< of `Decomposition::linkage`
};

/// Links that the joints do not hold, or hold too often, or whose drivers' laws read one another in
/// a circle.
struct Imbalance {
  int surplus = 0;  ///< freedoms, or constraints, that are left over
  std::vector<std::string> links;
  std::vector<std::string> joints;
};

/// What drivers place, tie together and read.
struct DrivenBodies {
  Table<LinkIndex, bool> placed;  ///< the ground, and what it carries
  Table<LinkIndex, LinkIndex>
      carrier;  ///< one link of those that drivers tie together, or the link itself
  Table<ElementaryJointIndex, bool> driven;  ///< joints with drivers, which constrain nothing else
  /// For each joint with a driver, the links that its law reads.
  Table<ElementaryJointIndex, std::vector<LinkIndex>> read;
};

/// The groups of a linkage; or, where it cannot be decomposed, the links that prevent it.
struct Decomposition {
  Linkage linkage;  ///< with every pin of several links as joints of two
  std::vector<Component> components;
  Imbalance free;        ///< the under-constrained part
  Imbalance overloaded;  ///< the over-constrained part
  /// Links that need one another because of what the laws of drivers read, and the joints of these
  /// drivers. If there are any, nothing is decomposed.
  Imbalance coupled;
};

/// Matches the freedoms of the unplaced links (three each, and two for the point of a pin of
/// several links) with the constraints of the joints (two each); links that drivers tie together
/// count as one. Where the maximum matching leaves some over, the parts that alternating paths
/// reach from them are the under- and over-constrained parts (Dulmage-Mendelsohn). Otherwise all
/// links are matched once more, one by one, a joint with a driver making three constraints. A link
/// depends on what its matched joints join it to, and the strongly connected components of that
/// relation are the groups: no smaller part can be solved alone. They come in an order in which
/// each depends on earlier ones only, and the laws of its drivers read earlier ones only; smaller
/// groups first, and then in the order of their links' names.
[[nodiscard]] Decomposition decompose(const Linkage& linkage, const DrivenBodies& bodies);

}  // namespace assur::mechanism::plan
