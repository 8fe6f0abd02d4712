// Statements of a solver that place the links of a scene.
#pragma once

#include <string>
#include <vector>

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// Statements that place links, and the members of the slides that they place.
struct PlacingStatements {
  cpp::Block block;
  std::vector<std::string> slides;
};

/// Places the links that the ground carries.
[[nodiscard]] PlacingStatements driving_statements(const SolverScene& solver);
/// Holds a group's external joints at their positions on moving links.
[[nodiscard]] cpp::Block holding_statements(const SolverScene& solver, mechanism::GroupIndex group);
/// Places the links and slides of a group in one of its configurations.
[[nodiscard]] PlacingStatements placing_statements(const SolverScene& solver,
                                                   mechanism::GroupIndex group,
                                                   const SpecialisedGroup& special);

}  // namespace assur::generator::emission::scene
