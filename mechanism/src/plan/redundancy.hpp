// Turns a mechanism with too many constraints into one without them, and what they were.
#pragma once

#include <assur/mechanism/error.hpp>
#include <assur/mechanism/request.hpp>
#include <assur/mechanism/structure.hpp>
#include <string>
#include <vector>

namespace assur::mechanism::plan {

/// What was described of a mechanism that is planned without some of its constraints.
struct Described {
  Mechanism mechanism;
  Request request;
};

struct BalancedMechanism {
  Mechanism mechanism;
  Structure structure;
  std::vector<RedundantJoint> redundant;
};

/// The most that may be left out of one joint. Without one constraint, a pin becomes a pin in a
/// slot along its link, a slide becomes a pin in a slot, and a pin in a slot is left out as a
/// whole. Without two constraints, a pin or a slide is left out as a whole.
enum class LeftOut : unsigned char {
  joints,      ///< one or two constraints
  doubles,     ///< one constraint, or two where another joint holds the same two links
  constraints  ///< one constraint
};

/// The mechanism without what is described to be left out of it, in the order of names; what is
/// told twice is left out once. Throws MechanismError where that leaves no known groups.
[[nodiscard]] BalancedMechanism without_all(const Mechanism& mechanism,
                                            std::vector<RedundantJoint> redundant);

/// A search through more would take longer than what is found is worth.
inline constexpr int most_surplus = 8;

/// The mechanism with as many constraints less as it has too many; nothing where these are more
/// than `most_surplus`. The ways to leave the last one out come in order: those that keep the
/// joints of the names in `kept` first, then those with the smallest groups, and then by the names
/// of joints, those with slots on bars first; a group may move freely where it is small. Nothing
/// where no way leaves a mechanism whose groups are known.
[[nodiscard]] std::vector<BalancedMechanism> balanced(const Mechanism& mechanism,
                                                      const OverConstrained& fault, LeftOut most,
                                                      const std::vector<std::string>& kept);

}  // namespace assur::mechanism::plan
