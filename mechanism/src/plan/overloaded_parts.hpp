// Turns a mechanism with too many constraints into the parts that have too many on their own.
#pragma once

#include <assur/mechanism/error.hpp>
#include <assur/mechanism/structure.hpp>
#include <vector>

namespace assur::mechanism::plan {

/// Returns, for each part that has too many constraints, which links belong to it or carry it by
/// drivers. Two parts share only links that the ground and drivers place, so what is left out of
/// one changes nothing in another. Returns no part if the law of a driver reads a joint.
[[nodiscard]] std::vector<Table<LinkIndex, bool>> overloaded_parts(const Mechanism& mechanism,
                                                                   const OverConstrained& fault);

/// Turns what is left out of `mechanism.only(kept)` into what is left out of the whole mechanism,
/// whose features have other indices.
[[nodiscard]] std::vector<RedundantJoint> of_whole(const Mechanism& mechanism,
                                                   const Table<LinkIndex, bool>& kept,
                                                   std::vector<RedundantJoint> redundant);

}  // namespace assur::mechanism::plan
