// Turns a scene into the header of a solver for that scene alone.
#pragma once

#include "emission/emit.hpp"
#include "scene/scene.hpp"

namespace assur::generator {

/// The header `assur/scenes/<file>.hpp` of a scene: its groups with all dimensions as numbers, and
/// only the derivatives, points and parameters that the scene wants. Derivatives are to the
/// parameters that have a tolerance, to all if none has. Throws InputError for a scene that has no
/// solver: it is over- or under-constrained, or a group is degenerate or not known.
[[nodiscard]] EmittedFile emit_scene(const Scene& scene);

}  // namespace assur::generator
