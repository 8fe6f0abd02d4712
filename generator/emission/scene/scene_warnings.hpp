// Warnings about special geometry of a scene at its own numbers.
#pragma once

#include <assur/mechanism/scene_file.hpp>
#include <string>
#include <vector>

namespace assur::generator::emission::scene {

/// Warnings, one line each: joints with redundant constraints, sensitivities of forces, which only
/// `assur solve` computes, and, at the scene's own numbers, a group with a self-motion, the number
/// of near-singular configurations, or that the links do not close. A solver is emitted all the
/// same, and its results show it. With more than ten groups only joints are reported:
/// configurations may be too many to list. Requires a scene that has a solver.
[[nodiscard]] std::vector<std::string> scene_warnings(const mechanism::Scene& scene);

}  // namespace assur::generator::emission::scene
