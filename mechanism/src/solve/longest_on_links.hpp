// Turns the values of a mechanism's features into a length that measures its size.
#pragma once

#include <assur/mechanism/values.hpp>

namespace assur::mechanism::solve {

/// The longest distance between two features of one link, which no motion changes; where no link
/// has two, the largest coordinate of a feature, and one where that is zero. In the scene's unit;
/// only features of joints and outputs count.
[[nodiscard]] double longest_on_links(const Values& values);

}  // namespace assur::mechanism::solve
