// Statements that find all joint forces of a scene in one linear system.
#pragma once

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// Statements that fill the efforts and forces of a state from the equilibrium of all links; empty
/// if no forces are wanted.
[[nodiscard]] cpp::Block equilibrium_statements(const SolverScene& solver);

}  // namespace assur::generator::emission::scene
