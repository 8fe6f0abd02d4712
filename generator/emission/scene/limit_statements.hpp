// Turns the limits of a scene's joints, and those that are redundant, into the statements of its
// solver that test them.
#pragma once

#include <string>
#include <vector>

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// Returns whether every joint keeps its limits and holds, where everything is placed; nothing
/// where no joint has any and none is redundant.
[[nodiscard]] std::vector<std::string> limit_statements(const SolverScene& solver);

}  // namespace assur::generator::emission::scene
