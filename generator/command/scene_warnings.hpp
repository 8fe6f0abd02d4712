// Turns what is odd in a scene that can be solved all the same into lines on standard error.
#pragma once

#include <assur/mechanism/scene_file.hpp>

namespace assur::generator::command {

/// Names the links that turn freely and are left at rest.
void warn_of_idle_links(const mechanism::Scene& scene);
/// Tells that a sweep moves nothing, if no link and no driver reads its parameter.
void warn_of_idle_sweep(const mechanism::Scene& scene);

}  // namespace assur::generator::command
