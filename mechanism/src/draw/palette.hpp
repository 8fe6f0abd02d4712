// Distinct colours and dashes for the numbers of configurations.
#pragma once

#include <array>
#include <cstddef>

namespace assur::mechanism::draw {

struct Colour {
  const char* light;  ///< on white
  const char* dark;   ///< on nearly black
};

/// The colours of Okabe and Ito, which colour-blind people can distinguish, without their yellow,
/// which is too pale on white. On black all are lighter.
inline constexpr std::array<Colour, 6> colours = {{{"#0072b2", "#5b9dff"},
                                                   {"#d55e00", "#ff8b3d"},
                                                   {"#009e73", "#35cfa0"},
                                                   {"#cc79a7", "#eba4cc"},
                                                   {"#e69f00", "#f5c04f"},
                                                   {"#56b4e9", "#93dcff"}}};
inline constexpr std::array<const char*, 4> dashes = {"", "4 2", "1.2 1.8", "6 2 1.2 2"};

inline constexpr std::size_t colour_of_forces = 3;  ///< as on pages
inline constexpr Colour ink = {"#1b1f24", "#e6e8ea"};
inline constexpr Colour muted = {"#6b7280", "#9aa4b0"};
inline constexpr Colour paper = {"#ffffff", "#15181c"};

/// The colours repeat, each time with other dashes.
[[nodiscard]] constexpr std::size_t colour_of(int configuration) {
  return configuration < 1 ? 0 : static_cast<std::size_t>(configuration - 1) % colours.size();
}
[[nodiscard]] constexpr const char* dash_of(int configuration) {
  return configuration < 1
             ? ""
             : dashes[static_cast<std::size_t>(configuration - 1) / colours.size() % dashes.size()];
}

}  // namespace assur::mechanism::draw
