// Turns lengths of a drawing into places of a picture, 320 units of a quarter of a millimetre wide.
#pragma once

#include <assur/mechanism/drawing.hpp>

namespace assur::mechanism::draw {

/// The height of the picture, and the scale and place of the drawing in it.
struct Picture {
  static constexpr double width = 320;
  double height;
  double scale;  ///< units of the picture for one of the scene
  double x, y;   ///< of the scene at the picture's upper left corner

  [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector2d& place) const {
    return {scale * (place.x() - x), scale * (y - place.y())};
  }
};

/// The picture that holds all of the drawing, with room for `legend` below.
[[nodiscard]] Picture picture_of(const Drawing& drawing, double legend);

/// The longest of 1, 2, 5 times a power of ten that is no longer than `longest`.
[[nodiscard]] double round_length(double longest);

}  // namespace assur::mechanism::draw
