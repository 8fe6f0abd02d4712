// Turns the steps that place a scene's links into the statements of its solver.
#pragma once

#include <string>
#include <vector>

#include "emission/solver_scene.hpp"
#include "scene/group_pose.hpp"

namespace assur::generator {

/// Statements that place links, and the members of the slides that they place.
struct PlacingStatements {
  std::vector<std::string> lines;
  std::vector<std::string> slides;
};

/// Places the driven links.
[[nodiscard]] PlacingStatements driving_statements(const SolverScene& solver);
/// Holds a group's external joints where moving links have them.
[[nodiscard]] std::vector<std::string> holding_statements(const SolverScene& solver,
                                                          const PosedGroup& group);
/// Places the links and slides of a group in one of its configurations.
[[nodiscard]] PlacingStatements placing_statements(const SolverScene& solver,
                                                   const PosedGroup& group);
/// Fills a state from what is placed.
[[nodiscard]] std::vector<std::string> listing_statements(const SolverScene& solver,
                                                          const std::vector<std::string>& slides);

}  // namespace assur::generator
