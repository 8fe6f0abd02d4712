// Turns the redundant joints of a scene into the tests of its solver once all links are placed.
#pragma once

#include <vector>

#include "emission/scene/function_body.hpp"
#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// An expression for each redundant joint: whether its features coincide, to rounding or to the
/// scene's tolerance. `body` gets the numbers that they read.
[[nodiscard]] std::vector<cpp::Expression> redundancy_tests(const SolverScene& solver,
                                                            FunctionBody& body);

/// Statements that return how far the worst redundant joint is from holding, relative to the
/// largest coordinate; none without redundant joints, and none if the scene states a tolerance.
[[nodiscard]] cpp::Block redundant_gap(const SolverScene& solver);

}  // namespace assur::generator::emission::scene
