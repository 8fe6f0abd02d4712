// Turns a linkage with placed links into its Assur groups, in the order in which they are solved.
#pragma once

#include <assur/mechanism/structure.hpp>
#include <string>
#include <vector>

namespace assur::mechanism::plan {

/// The links of one Assur group and all their joints, among themselves and to links placed before.
struct Component {
  std::vector<LinkIndex> links;              ///< carriers, ascending
  std::vector<ElementaryJointIndex> joints;  ///< of `Decomposition::linkage`
};

/// Links that the joints do not hold, or hold too often.
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
  /// For each link the links that drivers' laws read before they can place it against its carrier.
  Table<LinkIndex, std::vector<LinkIndex>> read_for;
};

struct Decomposition {
  Linkage linkage;  ///< with every pin of several links as joints of two
  std::vector<Component> components;
  Imbalance free;        ///< the under-constrained part
  Imbalance overloaded;  ///< the over-constrained part
  /// Links that wait for one another through what drivers' laws read; then nothing is decomposed.
  std::vector<std::string> coupled;
};

/// Matches the freedoms of the unplaced links (three each, and two for the point of a pin of
/// several links) with the constraints of the joints (two each). Where the maximum matching leaves
/// some over, the parts that alternating paths reach are the under- and over-constrained parts
/// (Dulmage-Mendelsohn). Otherwise a link depends on what its matched joints join it to, and the
/// strongly connected components of that relation are the groups: no smaller part can be solved
/// alone. They come in an order in which each depends on earlier ones only, smaller groups first.
[[nodiscard]] Decomposition decompose(const Linkage& linkage, const DrivenBodies& bodies);

}  // namespace assur::mechanism::plan
