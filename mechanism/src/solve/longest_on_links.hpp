// Length that measures the size of a mechanism, from features of its links.
#pragma once

#include <assur/mechanism/values.hpp>

namespace assur::mechanism::solve {

/// The longest distance between two features of one link, which no motion changes. If no link has
/// two, the largest coordinate of a feature, and one if that is zero. In the scene's unit; only
/// features of joints and outputs count.
[[nodiscard]] double longest_on_links(const Values& values);

}  // namespace assur::mechanism::solve
