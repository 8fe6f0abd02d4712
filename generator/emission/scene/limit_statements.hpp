// Statements that test the limits and the redundant joints of a scene.
#pragma once

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// Statements that return whether every joint is within its limits and every redundant joint holds,
/// for placed links; empty if no joint has limits or is redundant.
[[nodiscard]] cpp::Block limit_statements(const SolverScene& solver);

}  // namespace assur::generator::emission::scene
