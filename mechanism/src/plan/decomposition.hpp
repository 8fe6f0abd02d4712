// Decomposition of a linkage with placed links into its Assur groups, in the order of solving.
#pragma once

#include <assur/mechanism/structure.hpp>
#include <string>
#include <vector>

namespace assur::mechanism::plan {

/// The links of one Assur group, with the links that drivers connect to them, and all their joints
/// without drivers, among themselves and to links placed before. A link that only a driver places
/// is a component without joints.
struct Component {
  std::vector<LinkIndex> links;              ///< ascending
  std::vector<ElementaryJointIndex> joints;  ///< of `Decomposition::linkage`
};

/// Links that are under- or over-constrained, or whose drivers' laws read one another in a cycle.
struct Imbalance {
  int surplus = 0;  ///< unmatched freedoms or constraints
  std::vector<std::string> links;
  std::vector<std::string> joints;
};

/// The links that drivers place and connect, and the links that their laws read.
struct DrivenBodies {
  Table<LinkIndex, bool> placed;  ///< the ground, and what it carries
  Table<LinkIndex, LinkIndex>
      carrier;  ///< one link of those that drivers connect, or the link itself
  Table<ElementaryJointIndex, bool> driven;  ///< joints with drivers, which constrain nothing else
  /// For each joint with a driver, the links that its law reads.
  Table<ElementaryJointIndex, std::vector<LinkIndex>> read;
};

/// The groups of a linkage, or the links that prevent its decomposition.
struct Decomposition {
  Linkage linkage;  ///< with every pin of several links as joints of two
  std::vector<Component> components;
  Imbalance free;        ///< the under-constrained part
  Imbalance overloaded;  ///< the over-constrained part
  /// Links that depend on one another through the laws of drivers, and the joints of these drivers.
  /// If there are any, no group is found.
  Imbalance coupled;
};

/// Matches the freedoms of the unplaced links (three each, and two for the point of a pin of
/// several links) with the constraints of the joints (two each); links that drivers connect count
/// as one. If the maximum matching leaves some unmatched, the parts that alternating paths reach
/// from them are the under- and over-constrained parts (Dulmage-Mendelsohn). Otherwise all links
/// are matched once more, separately, with three constraints for a joint with a driver. A link
/// depends on the links to which its matched joints connect it, and the strongly connected
/// components of that relation are the groups: no smaller part can be solved alone. They come in an
/// order in which each group, and the laws of its drivers, depend on earlier ones only; smaller
/// groups first, and then in the order of their links' names.
[[nodiscard]] Decomposition decompose(const Linkage& linkage, const DrivenBodies& bodies);

}  // namespace assur::mechanism::plan
