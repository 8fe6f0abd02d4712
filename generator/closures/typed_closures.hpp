// The closures that a user types in an audit file.
#pragma once

#include "closures/closure_system.hpp"

namespace assur::generator::closures {

/// A mechanism given by its typed closures.
struct TypedClosures {
  std::string file;
  std::string source;              ///< its origin as stated in the file
  std::vector<std::string> lines;  ///< its `let`, `loop` and `closure` statements as typed
  ClosureSystem system;
};

/// Reads angle, length, unknown, moving, let, loop and closure of an audit file. Throws InputError
/// for errors, for a `model`, and if closures or unknowns are missing.
[[nodiscard]] TypedClosures read_typed_closures(const std::string& file);

}  // namespace assur::generator::closures
