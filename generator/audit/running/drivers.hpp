// Turns a user's program into the text of a small program, the driver, that computes its values.
#pragma once

#include "audit/running/program_values.hpp"

namespace assur::generator::audit::running {

/// A driver reads `points`, one point per line, and appends the entries for each point as a line to
/// `values`. It writes what is wrong with a result to `complaint` and ends with status 3.
struct Driver {
  std::string file_name;
  std::string text;
};

/// What a driver, or the compiler of one, says where it cannot tell how to read an entry.
inline constexpr const char* entry_is_unclear = "assur_cannot_tell_how_an_entry_is_read";

[[nodiscard]] Driver driver_of(const UserProgram& program, const MatrixSize& size,
                               const std::vector<std::string>& names);

}  // namespace assur::generator::audit::running
