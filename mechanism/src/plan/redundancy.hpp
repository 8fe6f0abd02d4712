// Turns a mechanism with too many constraints into one without them, and what they were.
#pragma once

#include <assur/mechanism/error.hpp>
#include <assur/mechanism/structure.hpp>
#include <optional>
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

/// The mechanism with as many constraints less as it has too many. Of the ways to leave them out,
/// the one with the smallest groups, and then the first by the names of joints and links: either a
/// pin holds by a slot alone, along the link, or a joint does not hold a link at all. Nothing where
/// no way leaves a mechanism whose groups are known.
[[nodiscard]] std::optional<BalancedMechanism> balanced(const Mechanism& mechanism,
                                                        const OverConstrained& fault);

}  // namespace assur::mechanism::plan
