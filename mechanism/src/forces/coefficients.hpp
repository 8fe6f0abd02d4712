// First derivatives of the links' poses with respect to the coordinates of the free drivers.
#pragma once

#include "balance.hpp"

namespace assur::mechanism::forces {

/// Kinematic coefficients with the first derivatives of the links alone.
[[nodiscard]] KinematicCoefficients first_coefficients(const Values& values,
                                                       const Configuration& configuration,
                                                       const Balance& balance);

}  // namespace assur::mechanism::forces
