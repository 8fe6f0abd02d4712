// Warnings about scenes that can be solved but are probably not as intended.
#pragma once

#include <assur/mechanism/scene_file.hpp>

namespace assur::generator::command {

/// Names the links that can rotate freely and are left at rest.
void warn_of_idle_links(const mechanism::Scene& scene);
/// Warns if no link and no driver depends on the parameter of a sweep.
void warn_of_idle_sweep(const mechanism::Scene& scene);

}  // namespace assur::generator::command
