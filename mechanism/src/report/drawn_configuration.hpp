// Configuration of a solution that is nearest to the drawing of its scene.
#pragma once

#include <assur/mechanism/report.hpp>
#include <optional>

namespace assur::mechanism::report {

/// The configuration that is nearest to the drawing of a scene.
struct DrawnConfiguration {
  Nearest nearest;
  bool is_numbered;  ///< whether its number among all configurations is known
};

/// Nothing for a scene without a drawing, or without a configuration.
[[nodiscard]] std::optional<DrawnConfiguration> drawn_configuration(const Report& report);

}  // namespace assur::mechanism::report
