// Members of a solver's states for the results that a scene wants.
#pragma once

#include "emission/cpp/page.hpp"
#include "emission/scene/solver_scene.hpp"

namespace assur::generator::emission::scene {

/// Members by their names, each with the comma that follows it in a list.
[[nodiscard]] cpp::View::List member_list(const std::vector<std::string>& members);

/// Sets the members of a state, and of its links, slides and outputs, as lists of arguments. The
/// view must already show the members for forces.
void show_state_members(const SolverScene& solver, bool has_links, bool has_slides,
                        cpp::View& view);

}  // namespace assur::generator::emission::scene
