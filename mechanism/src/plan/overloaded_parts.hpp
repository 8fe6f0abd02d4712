// Turns a mechanism with too many constraints into its parts in which they can be found one by one.
#pragma once

#include <assur/mechanism/error.hpp>
#include <assur/mechanism/structure.hpp>
#include <vector>

namespace assur::mechanism::plan {

/// For each part that has constraints too many, whether a link is of it, or carries it on drivers.
/// Two parts share no link but such as the ground and drivers place, so that what is left out of
/// one changes nothing in another. None where laws of drivers read joints.
[[nodiscard]] std::vector<Table<LinkIndex, bool>> overloaded_parts(const Mechanism& mechanism,
                                                                   const OverConstrained& fault);

/// What is left out of `mechanism.only(kept)`, by the features of the whole mechanism.
[[nodiscard]] std::vector<RedundantJoint> of_whole(const Mechanism& mechanism,
                                                   const Table<LinkIndex, bool>& kept,
                                                   std::vector<RedundantJoint> redundant);

}  // namespace assur::mechanism::plan
