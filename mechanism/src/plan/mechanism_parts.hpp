// Parts of a mechanism that can be planned alone: those with too many constraints, and the part
// that is reported.
#pragma once

#include <assur/mechanism/error.hpp>
#include <assur/mechanism/request.hpp>
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

/// A part of a mechanism, with the request for it.
struct ReportedPart {
  Mechanism mechanism;
  Request request;  ///< with the part's links and joints in place of the mechanism's
};

/// The part of the mechanism that consists of the links that are reported or carry outputs, and of
/// all links that hold them, up to the ground.
[[nodiscard]] ReportedPart reported_part(const Mechanism& mechanism, const Structure& structure,
                                         const Request& request);

}  // namespace assur::mechanism::plan
