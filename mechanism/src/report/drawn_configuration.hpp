// Turns a solution into the one of its configurations that is nearest to the drawing.
#pragma once

#include <assur/mechanism/report.hpp>
#include <optional>

namespace assur::mechanism::report {

/// The configuration that is nearest to the drawing of a scene.
struct DrawnConfiguration {
  Nearest nearest;
  bool is_numbered;  ///< whether its number among all configurations is known
};

/// Nothing for a scene without a drawing, and where there is no configuration.
[[nodiscard]] std::optional<DrawnConfiguration> drawn_configuration(const Report& report);

}  // namespace assur::mechanism::report
