// Emits a solver for a single scene.
#pragma once

#include <assur/mechanism/scene_file.hpp>
#include <string>
#include <vector>

#include "emission/cpp/files.hpp"

namespace assur::generator::emission::scene {

/// The languages from which a solver can be called, besides C++.
enum class Interface : unsigned char { cpp, c, c_float };

/// The header `assur/scenes/<file>.hpp` of a scene: its groups with all dimensions as numbers, and
/// only the derivatives, points and parameters that the scene wants. Derivatives are by the
/// parameters that have a tolerance or are variable, or by all if there are none. Throws
/// MechanismError for a scene that has no solver: it is over- or under-constrained, or a group is
/// degenerate or unknown. `options`: those of the command except variable parameters, for the line
/// that states how to reproduce the files. The files of the interface come after the header.
[[nodiscard]] std::vector<cpp::EmittedFile> emit_scene(const mechanism::Scene& scene,
                                                       const std::string& options = "",
                                                       Interface interface = Interface::cpp);

}  // namespace assur::generator::emission::scene
