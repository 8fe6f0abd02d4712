// Parts of a picture in SVG: scale, elements, shapes of a mechanism, legend.
#pragma once

#include <assur/mechanism/drawing.hpp>
#include <string>
#include <utility>
#include <vector>

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

/// A path or a circle.
struct SvgElement {
  std::string kind;  ///< its class
  /// The attributes for its position: `d`, or `cx` and `cy`.
  std::vector<std::pair<std::string, std::string>> places;
  std::string more = {};   ///< other attributes, each preceded by a blank
  std::string title = {};  ///< its name
};
using SvgElements = std::vector<SvgElement>;

/// The SVG of elements.
[[nodiscard]] std::string written(const SvgElements& elements);

/// The SVG of elements at several moments, repeated at equal intervals.
[[nodiscard]] std::string written_moving(const std::vector<SvgElements>& moments, double seconds);

/// The ground's part: guides, slots and supports.
[[nodiscard]] SvgElements ground_elements(const Drawing& drawing, const Picture& picture);
/// A stance at full strength: links, slots, blocks, cylinders, then pins and outputs' points.
[[nodiscard]] SvgElements stance_elements(const Drawing& drawing, const Stance& stance,
                                          const Picture& picture);
/// The links of a stance as thin lines.
[[nodiscard]] SvgElements outline_elements(const Drawing& drawing, const Stance& stance,
                                           const Picture& picture);

/// The height of the legend, in units of the picture.
[[nodiscard]] double legend_height(const Drawing& drawing);
/// The elements of the legend, below the drawing.
[[nodiscard]] std::string legend_elements(const Drawing& drawing, const Picture& picture);

/// The sign of a singular event, about a place of the picture.
[[nodiscard]] std::string mark_element(const std::string& event, const Eigen::Vector2d& at,
                                       const std::string& title);

/// An arrow between two places of the picture; empty if it is too short to be visible.
[[nodiscard]] std::string arrow_element(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                                        const std::string& title);

}  // namespace assur::mechanism::draw
