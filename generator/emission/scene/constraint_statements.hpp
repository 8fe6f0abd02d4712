// Statements by which a solver satisfies all joints of a scene together, redundant ones included.
#pragma once

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// Statements that move the placed links until all constraints hold together, and return whether
/// they do; `slides` are the members of the slides that are placed. Empty for a scene without
/// redundant constraints, with a tolerance for them, with a driver that moves links placed by
/// groups or whose law reads their positions, or with so many links that the statements would need
/// too much stack.
[[nodiscard]] cpp::Block settling_statements(const SolverScene& solver,
                                             const std::vector<std::string>& slides);

}  // namespace assur::generator::emission::scene
