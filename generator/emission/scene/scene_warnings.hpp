// Turns a scene into warnings of what its own numbers make of it.
#pragma once

#include <assur/mechanism/scene_file.hpp>
#include <string>
#include <vector>

namespace assur::generator::emission::scene {

/// What the scene's own numbers make special, a line each: a group that moves freely, how many
/// configurations are near-singular, or that the links cannot reach. A solver is emitted all the
/// same, and answers so. Nothing is said of a mechanism of more than ten groups: its configurations
/// may be too many to list. Requires a scene that has a solver.
[[nodiscard]] std::vector<std::string> scene_warnings(const mechanism::Scene& scene);

}  // namespace assur::generator::emission::scene
