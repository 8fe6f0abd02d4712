// What of a user's code cannot be read, and where.
#pragma once

#include <stdexcept>
#include <string>

#include "closures/statement.hpp"

namespace assur::generator::audit::code {

struct CodeError : std::runtime_error {
  CodeError(const std::string& what, closures::Place at) : std::runtime_error(what), place(at) {}
  closures::Place place;
};

/// What remains for code that is no list of plain assignments.
inline const std::string by_running = "; audit it by running: 'printed run' with --run";

}  // namespace assur::generator::audit::code
