// Turns the closures that an audit file types into a closure system, leaving out what it prints.
#pragma once

#include "closures/closure_system.hpp"

namespace assur::generator::closures {

/// A mechanism by its closures, as its user types them.
struct TypedClosures {
  std::string file;
  std::string source;              ///< what the file says of its origin
  std::vector<std::string> lines;  ///< its `let`, `loop` and `closure` statements, for people
  ClosureSystem system;
};

/// Reads angle, length, unknown, moving, let, loop and closure of an audit file. Throws InputError
/// for what cannot be used, for a `model` and where closures or unknowns are missing.
[[nodiscard]] TypedClosures read_typed_closures(const std::string& file);

}  // namespace assur::generator::closures
