// Turns the axes of a grid into entries of a description, and back.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/description.hpp"

namespace assur::generator::campaign {

/// An axis of the grid, for people.
struct NamedAxis {
  std::string name;
  double from, to;
  std::uint64_t count;
};

/// The entry of an axis in a description.
[[nodiscard]] std::string axis_text(const NamedAxis& axis);

/// The axes of a map, in their order; a table of a sample has none.
[[nodiscard]] std::vector<NamedAxis> axes_of(const Description& description);

}  // namespace assur::generator::campaign
