// Turns an expression of Pyslvs into a mechanism.
#pragma once

#include <string>

#include "foreign/foreign_mechanism.hpp"

namespace assur::mechanism::foreign {

/// The mechanism of an expression `M[J[R, P[0, 0], L[ground, crank]], ...]`, whose points are P0,
/// P1 and so on. `driver` is the point of the driven joint; where it is empty, the first pin of one
/// link on the ground. Throws MechanismError for a text that is not such an expression, and for a
/// driver that is none of its joints.
[[nodiscard]] ForeignMechanism pyslvs_mechanism(const std::string& text, const std::string& driver);

}  // namespace assur::mechanism::foreign
