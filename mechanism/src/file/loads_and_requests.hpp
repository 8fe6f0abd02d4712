// The parts of a scene beside its mechanism: what loads it, and what is asked of it.
#pragma once

#include <assur/mechanism/drawn_mechanism.hpp>

#include "json_values.hpp"

namespace assur::mechanism::file {

/// Adds what loads a scene to a mechanism that has its links and joints. Throws MechanismError for
/// a part that the mechanism does not have and for a value of the wrong form. Points of a drawing
/// that loads name become features of their links.
void read_loads(const SceneJson& root, Mechanism& mechanism, DrawnMechanism& drawn);

/// Fills a request with what a scene wants to know, of which parts, and along which sweep. Throws
/// MechanismError as read_loads does.
void read_request(const SceneJson& root, Mechanism& mechanism, const DrawnMechanism& drawn,
                  Request& request);

}  // namespace assur::mechanism::file
