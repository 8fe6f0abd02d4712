// Turns a mechanism and what is reported of it into the part of the mechanism that this depends on.
#pragma once

#include <assur/mechanism/request.hpp>
#include <assur/mechanism/structure.hpp>

namespace assur::mechanism::plan {

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
