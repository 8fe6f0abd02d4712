// Turns the values of a mechanism's features into the length that tells how large it is.
#pragma once

#include <assur/mechanism/values.hpp>

namespace assur::mechanism::solve {

/// The longest distance between two features of one link, which no motion changes; where no link
/// has two, the largest coordinate of a feature, and one where that is zero. In the scene's unit;
/// features that neither a joint nor an output has do not count.
[[nodiscard]] double longest_on_links(const Values& values);

}  // namespace assur::mechanism::solve
