// Turns what a picture shows into the line below it: its scale, its colours, its marks,
// its forces.
#pragma once

#include "draw/picture.hpp"

namespace assur::mechanism::draw {

/// How high the legend is, in units of the picture.
[[nodiscard]] double legend_height(const Drawing& drawing);
/// The elements of the legend, below the drawing.
[[nodiscard]] std::string legend_elements(const Drawing& drawing, const Picture& picture);

/// The sign of a singular event, about a place of the picture.
[[nodiscard]] std::string mark_element(const std::string& event, const Eigen::Vector2d& at,
                                       const std::string& title);

/// An arrow between two places of the picture; nothing where it is too short to be seen.
[[nodiscard]] std::string arrow_element(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                        const std::string& title);

}  // namespace assur::mechanism::draw
