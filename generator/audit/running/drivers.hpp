// Turns a user's program into the text of a small one beside it, which asks it for its values.
#pragma once

#include "audit/running/program_values.hpp"

namespace assur::generator::audit::running {

/// A driver reads `points`, a point a line, and appends to `values` a line for each: its entries.
/// What is wrong with a result goes to `complaint`, and the driver ends with status 3.
struct Driver {
  std::string file_name;
  std::string text;
};

/// What the driver in C++ or C makes the compiler say where it cannot tell how to read an entry.
inline constexpr const char* entry_is_unclear = "assur_cannot_tell_how_an_entry_is_read";

[[nodiscard]] Driver driver_of(const UserProgram& program, const MatrixSize& size,
                               const std::vector<std::string>& names);

}  // namespace assur::generator::audit::running
