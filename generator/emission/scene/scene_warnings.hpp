// Turns a scene into warnings of what is special about it at its own numbers.
#pragma once

#include <assur/mechanism/scene_file.hpp>
#include <string>
#include <vector>

namespace assur::generator::emission::scene {

/// Warnings, one line each: joints with redundant constraints and, at the scene's own numbers, a
/// group that moves freely, how many configurations are near-singular, or that the links cannot
/// reach. A solver is emitted all the same, and its results show it. For more than ten groups there
/// are only the warnings of joints: configurations may be too many to list. Requires a scene that
/// has a solver.
[[nodiscard]] std::vector<std::string> scene_warnings(const mechanism::Scene& scene);

}  // namespace assur::generator::emission::scene
