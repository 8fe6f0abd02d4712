// Motions that pass through a singular configuration.
#pragma once

#include "group_solver.hpp"

namespace assur::mechanism::solve {

/// Finds the rates of a configuration whose loop closures do not determine them to first order, by
/// following all constraints order by order (`motions_through`). If there is one motion, the
/// configuration gets its rates. If there are several, as at a crossing, they become its branches.
/// If there is none, as at a fold, the configuration stays as it is. A driver moves by its velocity
/// and acceleration, and its higher rates are zero. If only one driver moves, these do not matter
/// at a crossing.
void find_branches(const Values& values, Configuration& configuration);

/// Finds the derivatives of the links and slides of a configuration with respect to a parameter
/// that moves drivers alone, from all constraints together, if these determine them to one digit.
/// They lose fewer digits than group by group, where the rounding of each is passed on to the next.
void find_derivatives(const Values& values, const PlacedLinks& placed, ParameterIndex parameter,
                      Configuration& configuration);

}  // namespace assur::mechanism::solve
