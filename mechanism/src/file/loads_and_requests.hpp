// Readers of a scene's loads and of its request.
#pragma once

#include <assur/mechanism/drawn_mechanism.hpp>

#include "json_values.hpp"

namespace assur::mechanism::file {

/// Adds the loads of a scene to a mechanism that has its links and joints. Throws MechanismError
/// for a part that the mechanism does not have and for a value of the wrong form. Points of a
/// drawing in loads become features of their links.
void read_loads(const SceneJson& root, Mechanism& mechanism, DrawnMechanism& drawn);

/// Fills a request with the results, the reported parts and the sweep of a scene. Throws
/// MechanismError as read_loads does.
void read_request(const SceneJson& root, Mechanism& mechanism, const DrawnMechanism& drawn,
                  Request& request);

}  // namespace assur::mechanism::file
