// Turns the masses, gravity, loads and springs of a scene into the loading of its mechanism.
#pragma once

#include <assur/mechanism/drawn_mechanism.hpp>

#include "json_values.hpp"

namespace assur::mechanism::file {

/// Adds what loads a scene to a mechanism that has its links and joints. Throws MechanismError for
/// a part that the mechanism does not have and for a value of the wrong form. Points of a drawing
/// that loads name become features of their links.
void read_loads(const SceneJson& root, Mechanism& mechanism, DrawnMechanism& drawn);

}  // namespace assur::mechanism::file
