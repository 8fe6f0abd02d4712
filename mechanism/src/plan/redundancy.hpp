// Turns a mechanism with too many constraints into one without the excess ones, which it lists.
#pragma once

#include <assur/mechanism/error.hpp>
#include <assur/mechanism/structure.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace assur::mechanism::plan {

/// The structure of a mechanism, or the excess of its constraints, which may be redundant, or
/// another fault.
using FoundStructure = std::variant<Structure, OverConstrained, MechanismError>;
/// Finds what `structure_of` returns or throws.
[[nodiscard]] FoundStructure found_structure(const Mechanism& mechanism);

/// Whether the law of a driver, or a load, reads where a joint is: one that is left out has no
/// coordinate.
[[nodiscard]] bool is_read(const Mechanism& mechanism, JointIndex joint);

struct BalancedMechanism {
  Mechanism mechanism;
  Structure structure;
  std::vector<RedundantJoint> redundant;
};

/// The number of links of the largest group.
[[nodiscard]] std::size_t largest_group(const Structure& structure);

/// The most that may be left out of one joint. Without one constraint, a pin becomes a pin in a
/// slot along its link, a slide becomes a pin in a slot, and a pin in a slot is left out as a
/// whole. Without two constraints, a pin or a slide is left out as a whole.
enum class LeftOut : unsigned char {
  joints,      ///< one or two constraints
  doubles,     ///< one constraint, or two where another joint holds the same two links
  constraints  ///< one constraint
};

/// The mechanism without the given constraints, which are left out in the order of names; one that
/// is given twice is left out once. Nothing where that leaves no known groups.
[[nodiscard]] std::optional<BalancedMechanism> without_all(const Mechanism& mechanism,
                                                           std::vector<RedundantJoint> redundant);

/// The largest surplus for which constraints to leave out are sought; more would take too long.
inline constexpr int most_surplus = 8;

/// The ways to leave the excess constraints out of a mechanism, which differ in the last one. Those
/// that keep the joints named in `kept` come first, then those with the smallest groups (which may
/// move freely), and then they are in the order of the names of joints, with slots on bars first.
/// Empty where there are more than `most_surplus` excess constraints, or where no way leaves a
/// mechanism whose groups are known.
[[nodiscard]] std::vector<BalancedMechanism> balanced(const Mechanism& mechanism,
                                                      const OverConstrained& fault, LeftOut most,
                                                      const std::vector<std::string>& kept);

}  // namespace assur::mechanism::plan
