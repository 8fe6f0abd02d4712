// Turns the shapes of a stance into elements of an SVG picture.
#pragma once

#include "draw/picture.hpp"
#include "draw/svg_element.hpp"

namespace assur::mechanism::draw {

/// The ground's part: guides, slots and supports.
[[nodiscard]] SvgElements ground_elements(const Drawing& drawing, const Picture& picture);
/// A stance at full strength: links, slots, blocks, cylinders, then pins and outputs' points.
[[nodiscard]] SvgElements stance_elements(const Drawing& drawing, const Stance& stance,
                                          const Picture& picture);
/// The links of a stance as thin lines.
[[nodiscard]] SvgElements outline_elements(const Drawing& drawing, const Stance& stance,
                                           const Picture& picture);

}  // namespace assur::mechanism::draw
