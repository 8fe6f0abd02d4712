// Mechanisms from the texts of other programs, and their text as drawn scenes.
#pragma once

#include <string>

#include "foreign/foreign_mechanism.hpp"

namespace assur::mechanism::foreign {

/// The mechanism of a file of Linkage. Inputs with positive speeds turn clockwise. Throws
/// MechanismError for a text that is not such a file.
[[nodiscard]] ForeignMechanism linkage_mechanism(const std::string& text);

/// The mechanism of a payload, the part of a link after the question mark. Masses are in a unit
/// that makes forces newtons (pounds of force for lengths in inches). Throws MechanismError for a
/// payload that is damaged, or whose parts name missing parts.
[[nodiscard]] ForeignMechanism pmks_mechanism(const std::string& payload);

/// The mechanism of an expression `M[J[R, P[0, 0], L[ground, crank]], ...]`, whose points are P0,
/// P1 and so on. `driver` is the point of the driven joint; if it is empty, the first pin of one
/// link on the ground. Throws MechanismError for a text that is not such an expression, and for a
/// driver that is none of its joints.
[[nodiscard]] ForeignMechanism pyslvs_mechanism(const std::string& text, const std::string& driver);

/// The scene, with one line for each of its parts. Adds remarks on names that it changes.
[[nodiscard]] std::string scene_text(ForeignMechanism& mechanism);

}  // namespace assur::mechanism::foreign
