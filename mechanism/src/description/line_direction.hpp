// Turns a line without a direction into the error that names it.
#pragma once

#include <assur/mechanism/error.hpp>
#include <string>

namespace assur::mechanism::description {

/// The error for the line `links.L.F`, whose `along` is [0, 0].
[[nodiscard]] inline MechanismError refusal_of_direction(const std::string& line) {
  return {line + ".along", "[0, 0] has no direction; at least one of the numbers must not be zero"};
}

}  // namespace assur::mechanism::description
