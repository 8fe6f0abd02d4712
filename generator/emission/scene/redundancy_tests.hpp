// Turns the redundant joints of a scene into what its solver tests where everything is placed.
#pragma once

#include <string>
#include <vector>

#include "emission/scene/scene_lines.hpp"
#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// An expression for each redundant joint: whether its features coincide, to rounding or to the
/// scene's tolerance. The lines get the numbers that they read.
[[nodiscard]] std::vector<std::string> redundancy_tests(const SolverScene& solver,
                                                        SceneLines& lines);

/// Statements that return by how much the worst of them misses, in parts of the largest coordinate;
/// none without such joints, nor where the scene states a tolerance.
[[nodiscard]] std::vector<std::string> redundant_gap(const SolverScene& solver);

}  // namespace assur::generator::emission::scene
