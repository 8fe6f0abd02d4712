// Arrows for the forces in the joints of one configuration.
#pragma once

#include <assur/mechanism/drawing.hpp>
#include <assur/mechanism/plan.hpp>

namespace assur::mechanism::draw {

/// Adds the requested forces to a drawing of the configuration, whose diagonal is `size`: the
/// longest arrow is a quarter of it. Forces that are not determined have no arrow.
void add_forces(const Plan& plan, const Values& values, const Configuration& configuration,
                double size, Drawing& drawing);

}  // namespace assur::mechanism::draw
