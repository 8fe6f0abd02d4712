// Turns the limits of a scene's joints into the statement of its solver that tests them.
#pragma once

#include <string>
#include <vector>

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// Returns whether every joint keeps its limits, where everything is placed; nothing where no joint
/// has any.
[[nodiscard]] std::vector<std::string> limit_statements(const SolverScene& solver);

}  // namespace assur::generator::emission::scene
