// Pictures of a scene, with other values of some parameters, for notebooks and files.
#pragma once

#include <assur/mechanism/drawing.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <string>
#include <utility>
#include <vector>

namespace assur::python {

/// An SVG of a scene's configurations, with numbers in place of some parameters' formulas.
[[nodiscard]] std::string svg_of(const mechanism::Scene& scene,
                                 const std::vector<std::pair<std::string, double>>& replaced,
                                 const mechanism::DrawingChoice& choice);

}  // namespace assur::python
