// Turns the joints and loads of a scene into the statements that find all forces together.
#pragma once

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// Statements that fill the efforts and forces of a state from the equilibrium of all links; none
/// where no forces are wanted.
[[nodiscard]] cpp::Block equilibrium_statements(const SolverScene& solver);

}  // namespace assur::generator::emission::scene
