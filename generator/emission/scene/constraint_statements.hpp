// Turns all joints of a scene, of which some are redundant, into how its solver holds links by
// them.
#pragma once

#include <string>
#include <vector>

#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// Statements that move what is placed to where all constraints together hold it, and return
/// whether they do. None for a scene without redundant constraints, nor where they may miss by a
/// tolerance, where a driver moves links that groups place or reads where they are, where slides
/// are reported, or where many links would take more stack than solvers have.
[[nodiscard]] std::vector<std::string> settling_statements(const SolverScene& solver);

}  // namespace assur::generator::emission::scene
