// Turns an index as the generated tables count, which is an int, into the entry that it names.
#pragma once

#include <cstddef>

namespace assur::detail {

/// Eigen and the tables of generated models count by int, std::array by std::size_t.
template <typename Array>
[[nodiscard]] constexpr auto& entry(Array& array, int index) {
  return array[static_cast<std::size_t>(index)];
}

/// A count of a generated model as std::array takes it.
[[nodiscard]] constexpr std::size_t size(int count) { return static_cast<std::size_t>(count); }

/// Whether an unknown of a model is an angle in radians; otherwise it is a length.
template <typename Model>
[[nodiscard]] constexpr bool is_angle(int unknown) {
  return entry(Model::unknowns, unknown).is_angle;
}

}  // namespace assur::detail
