// Statements by which a solver satisfies all joints of a scene together, redundant ones included.
#pragma once

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// Statements that move the placed links until all constraints hold together, and return whether
/// they do. Empty for a scene without redundant constraints, with a tolerance for them, with a
/// driver that moves links placed by groups or whose law reads their positions, with reported
/// slides, or with so many links that the statements would need too much stack.
[[nodiscard]] cpp::Block settling_statements(const SolverScene& solver);

}  // namespace assur::generator::emission::scene
