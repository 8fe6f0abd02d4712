// Turns a singular configuration into the motions that go through it.
#pragma once

#include "group_solver.hpp"

namespace assur::mechanism::solve {

/// Finds the rates of a configuration whose loop closures do not determine them to first order, by
/// following its groups order by order (`branches_through`). One motion: the configuration gets its
/// rates. Several, as at a crossing: they are its branches. None, as at a fold: it stays as it is.
/// A driver moves as its velocity and acceleration say, and its higher rates are zero: at a
/// crossing along the motion of one driver they do not matter.
void find_branches(const Values& values, const PlacedLinks& placed, Configuration& configuration);

/// Finds how such a configuration follows a parameter that moves drivers alone, where there is one
/// way: as when a group is singular throughout a sweep.
void find_derivatives(const Values& values, const PlacedLinks& placed, ParameterIndex parameter,
                      Configuration& configuration);

}  // namespace assur::mechanism::solve
