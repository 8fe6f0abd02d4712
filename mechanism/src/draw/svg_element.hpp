// Turns elements of a picture, and where they are from moment to moment, into SVG.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace assur::mechanism::draw {

/// A path or a circle.
struct SvgElement {
  std::string kind;  ///< its class
  /// The attributes that say where it is: `d`, or `cx` and `cy`.
  std::vector<std::pair<std::string, std::string>> places;
  std::string more = {};   ///< other attributes, each with a blank before it
  std::string title = {};  ///< what it is called
};
using SvgElements = std::vector<SvgElement>;

/// The SVG of elements.
[[nodiscard]] std::string written(const SvgElements& elements);

/// The SVG of elements at several moments, which follow one another at equal times, over and over.
[[nodiscard]] std::string written_moving(const std::vector<SvgElements>& moments, double seconds);

}  // namespace assur::mechanism::draw
