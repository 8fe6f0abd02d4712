// Turns a scene's masses, loads and springs into the statements that find the forces in its joints.
#pragma once

#include <string>
#include <vector>

#include "emission/cpp/page.hpp"
#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// Throws MechanismError for forces that emitted solvers do not find.
void expect_forces(const SolverScene& solver);

/// The statements that fill what a state tells of forces, from what is placed; none where no forces
/// are wanted.
[[nodiscard]] cpp::Block force_statements(const SolverScene& solver);

/// Shows the members of a state that tell of forces.
void show_force_members(const SolverScene& solver, cpp::View& view);

}  // namespace assur::generator::emission::scene
