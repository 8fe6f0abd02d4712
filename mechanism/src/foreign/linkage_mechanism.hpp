// Turns a file of the program Linkage into a mechanism: rigid bodies, slots, inputs, actuators and
// gears.
#pragma once

#include <string>

#include "foreign/foreign_mechanism.hpp"

namespace assur::mechanism::foreign {

/// Inputs with positive speeds turn clockwise. Throws MechanismError for a text that is not such a
/// file.
[[nodiscard]] ForeignMechanism linkage_mechanism(const std::string& text);

}  // namespace assur::mechanism::foreign
