// Turns a place in a user's code that cannot be read into an exception.
#pragma once

#include <stdexcept>
#include <string>

#include "closures/statement.hpp"

namespace assur::generator::audit::code {

struct CodeError : std::runtime_error {
  CodeError(const std::string& what, closures::Place at) : std::runtime_error(what), place(at) {}
  closures::Place place;
};

/// The advice for code that is more than a list of plain assignments.
inline const std::string by_running = "; audit it by running: 'printed run' with --run";

}  // namespace assur::generator::audit::code
