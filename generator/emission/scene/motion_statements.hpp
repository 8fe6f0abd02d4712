// Statements that fill the kinematic coefficients and the equations of motion of a state.
#pragma once

#include "emission/cpp/page.hpp"
#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// Shows the functions that compute the coefficients and the dynamics that a scene wants, and their
/// members in the state. Returns the statements of the functions.
[[nodiscard]] cpp::Block show_motions(const SolverScene& solver, cpp::View& view);

}  // namespace assur::generator::emission::scene
