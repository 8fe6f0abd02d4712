// The text of a small program, the driver, that computes the values of a user's program.
#pragma once

#include <string>

#include "audit/running/program_values.hpp"

namespace assur::generator::audit::running {

/// A driver reads `points`, one point per line, and appends a line for each to `values`: `d` or,
/// for single precision, `s`, and the entries; or `!` and the error that ended the program there.
/// It ends with status 3 where it can give no values at all, and writes why to `complaint`: `!` and
/// an error, `?` and what else is wrong with the program, or what the result is in place of a
/// matrix.
struct Driver {
  std::string file_name;
  std::string text;
};

/// What a driver, or the compiler of one, says where it cannot tell how to read an entry.
inline constexpr const char* entry_is_unclear = "assur_cannot_tell_how_an_entry_is_read";

[[nodiscard]] Driver driver_of(const UserProgram& program, const MatrixSize& size,
                               const PointTable& table);

/// Whether the file declares a function that the code calls with a parameter of type float.
[[nodiscard]] bool has_single_parameters(const std::string& file_text, const std::string& code);

}  // namespace assur::generator::audit::running
