// Statements that fill a state from placed links, slides and outputs.
#pragma once

#include <string>
#include <vector>

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// Fills a state from the placed links and the slides with these members.
[[nodiscard]] cpp::Block listing_statements(const SolverScene& solver,
                                            const std::vector<std::string>& slides);

}  // namespace assur::generator::emission::scene
