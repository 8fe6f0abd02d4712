// Parts of a mechanism that can be planned separately: over-constrained ones, and the reported one.
#pragma once

#include <assur/mechanism/error.hpp>
#include <assur/mechanism/request.hpp>
#include <assur/mechanism/structure.hpp>
#include <vector>

namespace assur::mechanism::plan {

/// Returns, for each over-constrained part, the links that belong to it or carry it by drivers. Two
/// parts share only links that the ground and drivers place, so that the choice in one does not
/// affect another. Returns no part if the law of a driver reads a joint.
[[nodiscard]] std::vector<Table<LinkIndex, bool>> overloaded_parts(const Mechanism& mechanism,
                                                                   const OverConstrained& fault);

/// Converts the redundant joints of `mechanism.only(kept)` to those of the whole mechanism, whose
/// features have other indices.
[[nodiscard]] std::vector<RedundantJoint> of_whole(const Mechanism& mechanism,
                                                   const Table<LinkIndex, bool>& kept,
                                                   std::vector<RedundantJoint> redundant);

/// A part of a mechanism, with the request for it.
struct ReportedPart {
  Mechanism mechanism;
  Request request;  ///< with the part's links and joints instead of the mechanism's
};

/// The part of the mechanism with the links that are reported or have outputs, and all links that
/// hold them, up to the ground.
[[nodiscard]] ReportedPart reported_part(const Mechanism& mechanism, const Structure& structure,
                                         const Request& request);

}  // namespace assur::mechanism::plan
