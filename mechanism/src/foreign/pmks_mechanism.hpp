// Turns a link that PMKS+ shares into a mechanism with its masses and forces.
#pragma once

#include <string>

#include "foreign/foreign_mechanism.hpp"

namespace assur::mechanism::foreign {

/// The mechanism of a payload, the part of a link behind the question mark. Masses are in the unit
/// that makes forces newtons (pounds of force, where lengths are inches). Throws MechanismError for
/// a payload that is damaged, or whose parts name parts that are not there.
[[nodiscard]] ForeignMechanism pmks_mechanism(const std::string& payload);

}  // namespace assur::mechanism::foreign
