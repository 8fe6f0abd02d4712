// Turns a scene into warnings of what its own numbers make of it.
#pragma once

#include <assur/mechanism/scene_file.hpp>
#include <string>
#include <vector>

namespace assur::generator::emission::scene {

/// One line for each group that moves freely at the scene's own numbers and for each configuration
/// that is near singular there, or one if the links cannot reach: a solver is emitted all the same,
/// and answers so. Requires a scene that has a solver.
[[nodiscard]] std::vector<std::string> scene_warnings(const mechanism::Scene& scene);

}  // namespace assur::generator::emission::scene
