// Turns a configuration into how far its joints are from closed.
#pragma once

#include "scene/solve.hpp"

namespace assur::generator {

/// The largest distance by which a joint's features miss each other, in the scene's unit of length;
/// the angle between the lines of a prismatic joint counts as its sine times `length`.
[[nodiscard]] double closure_error(const Scene& scene, const ParameterValues& values,
                                   const AssemblyConfiguration& configuration, double length);

}  // namespace assur::generator
