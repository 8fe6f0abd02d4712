// Turns a mechanism with too many constraints into one without them, and what they were.
#pragma once

#include <assur/mechanism/error.hpp>
#include <assur/mechanism/structure.hpp>
#include <string>
#include <vector>

namespace assur::mechanism::plan {

/// A joint that must hold where the others do: two features, of one sort, that coincide.
struct RedundantJoint {
  std::string name;
  FeatureIndex one, other;
};

struct BalancedMechanism {
  Mechanism mechanism;
  Structure structure;
  std::vector<RedundantJoint> redundant;
};

/// What may be left out of a joint that has constraints too many.
enum class LeftOut : unsigned char {
  joints,      ///< a pin holds by a slot alone, along the link, or a joint holds a link not at all
  constraints  ///< the former alone
};

/// The mechanism with as many constraints less as it has too many. The ways to leave the last one
/// out come in order, those with the smallest groups first, and then by the names of joints and
/// links: a group may move freely where it is small. Nothing where no way leaves a mechanism whose
/// groups are known.
[[nodiscard]] std::vector<BalancedMechanism> balanced(const Mechanism& mechanism,
                                                      const OverConstrained& fault, LeftOut most);

}  // namespace assur::mechanism::plan
