// Access to arrays by the int indices of generated tables.
#pragma once

#include <cstddef>

namespace assur::detail {

/// Eigen and the tables of generated models count by int, std::array by std::size_t.
template <typename Array>
[[nodiscard]] constexpr auto& entry(Array& array, int index) {
  return array[static_cast<std::size_t>(index)];
}

/// A count of a generated model as std::size_t, for std::array.
[[nodiscard]] constexpr std::size_t size(int count) { return static_cast<std::size_t>(count); }

/// Whether an unknown of a model is an angle in radians; otherwise it is a length.
template <typename Model>
[[nodiscard]] constexpr bool is_angle(int unknown) {
  return entry(Model::unknowns, unknown).is_angle;
}

/// Whether any unknown of a model is an angle.
template <typename Model>
inline constexpr bool has_angles = [] {
  bool any = false;
  for (int unknown = 0; unknown < Model::unknown_count; ++unknown) {
    any = any || is_angle<Model>(unknown);
  }
  return any;
}();

}  // namespace assur::detail
