// Tests of a solver whether the redundant joints hold once all links are placed.
#pragma once

#include <vector>

#include "emission/scene/function_body.hpp"
#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// An expression for each redundant joint: whether its features coincide, to rounding or to the
/// scene's tolerance. `body` gets the numbers that they read.
[[nodiscard]] std::vector<cpp::Expression> redundancy_tests(const SolverScene& solver,
                                                            FunctionBody& body);

/// Statements that return the largest error of the redundant joints, relative to the largest
/// coordinate; empty without redundant joints, and if the scene states a tolerance.
[[nodiscard]] cpp::Block redundant_gap(const SolverScene& solver);

}  // namespace assur::generator::emission::scene
