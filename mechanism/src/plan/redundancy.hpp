// Choice of the excess constraints to leave out of an over-constrained mechanism.
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

/// Whether the law of a driver, or a load, reads a joint's coordinate, which a left-out joint does
/// not have.
[[nodiscard]] bool is_read(const Mechanism& mechanism, JointIndex joint);

struct BalancedMechanism {
  Mechanism mechanism;
  Structure structure;
  std::vector<RedundantJoint> redundant;
};

/// The number of links of the largest group.
[[nodiscard]] std::size_t largest_group(const Structure& structure);

/// The most constraints that may be left out of one joint. With one less, a pin becomes a pin in a
/// slot along its link, a slide becomes a pin in a slot, and a pin in a slot is left out entirely.
/// With two less, a pin or a slide is left out entirely.
enum class LeftOut : unsigned char {
  joints,      ///< one or two constraints
  doubles,     ///< one constraint, or two where another joint holds the same two links
  constraints  ///< one constraint
};

/// The mechanism without the given constraints, left out in the order of names; one that is given
/// twice is left out once. Nothing if the rest has an unsupported group.
[[nodiscard]] std::optional<BalancedMechanism> without_all(const Mechanism& mechanism,
                                                           std::vector<RedundantJoint> redundant);

/// The largest surplus of constraints that is searched; more would take too long.
inline constexpr int most_surplus = 8;

/// The choices of excess constraints to leave out of a mechanism, which differ in the last one.
/// Those that keep the joints named in `kept` come first, then those with the smallest groups
/// (which may move freely), and then they are in the order of the names of joints, with slots on
/// bars first. Empty if there are more than `most_surplus` excess constraints, or if every choice
/// leaves an unsupported group.
[[nodiscard]] std::vector<BalancedMechanism> balanced(const Mechanism& mechanism,
                                                      const OverConstrained& fault, LeftOut most,
                                                      const std::vector<std::string>& kept);

}  // namespace assur::mechanism::plan
