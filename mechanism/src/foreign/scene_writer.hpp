// Turns a mechanism of another program into the text of a drawn scene.
#pragma once

#include <string>

#include "foreign/foreign_mechanism.hpp"

namespace assur::mechanism::foreign {

/// The scene, with one line for each of its parts. Adds remarks on names that it changes.
[[nodiscard]] std::string scene_text(ForeignMechanism& mechanism);

}  // namespace assur::mechanism::foreign
