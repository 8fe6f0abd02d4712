// Statements that find the joint forces of a scene group by group.
#pragma once

#include <string>
#include <vector>

#include "emission/cpp/page.hpp"
#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// Statements that fill the efforts and forces of a state group by group, where all groups are
/// regular; empty if no forces are wanted, or constraints are redundant.
[[nodiscard]] cpp::Block force_statements(const SolverScene& solver);

/// Shows the members of a state for efforts and forces.
void show_force_members(const SolverScene& solver, cpp::View& view);

}  // namespace assur::generator::emission::scene
