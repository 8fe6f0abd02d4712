// Turns the redundant joints of a scene into the tests of its solver once all links are placed.
#pragma once

#include <string>
#include <vector>

#include "emission/scene/scene_lines.hpp"
#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// An expression for each redundant joint: whether its features coincide, to rounding or to the
/// scene's tolerance. `lines` gets the numbers that they read.
[[nodiscard]] std::vector<std::string> redundancy_tests(const SolverScene& solver,
                                                        SceneLines& lines);

/// Statements that return how far the worst redundant joint is from holding, relative to the
/// largest coordinate; none without redundant joints, and none if the scene states a tolerance.
[[nodiscard]] std::vector<std::string> redundant_gap(const SolverScene& solver);

}  // namespace assur::generator::emission::scene
