// Largest distance by which the joints of a configuration fail to close.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>

namespace assur::mechanism::solve {

/// The largest distance by which a joint's features miss each other, in the mechanism's unit of
/// length; the angle between the lines of a prismatic joint counts as its sine times `length`.
[[nodiscard]] double closure_error(const Values& values, const Configuration& configuration,
                                   double length);

}  // namespace assur::mechanism::solve
