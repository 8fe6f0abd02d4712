// Turns the limits of a scene's joints, and its redundant joints, into the statements of its solver
// that test them.
#pragma once

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// Statements that return whether every joint keeps its limits and every redundant joint holds,
/// once all links are placed; empty if no joint has limits or is redundant.
[[nodiscard]] cpp::Block limit_statements(const SolverScene& solver);

}  // namespace assur::generator::emission::scene
