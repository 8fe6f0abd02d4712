// Turns the joints of a scene, of which some are redundant, into the statements by which its solver
// makes all of them hold.
#pragma once

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// Statements that move the placed links to where all constraints hold together, and return whether
/// they do. There are none for a scene without redundant constraints, with a tolerance for them,
/// with a driver that moves links that groups place or reads where these are, with reported slides,
/// or with so many links that the statements would need too much stack.
[[nodiscard]] cpp::Block settling_statements(const SolverScene& solver);

}  // namespace assur::generator::emission::scene
