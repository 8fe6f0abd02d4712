// The driver: a small program that computes the values of a user's program.
#pragma once

#include <string>

#include "audit/running/program_values.hpp"

namespace assur::generator::audit::running {

/// A driver reads `points`, one point per line, and appends a line for each to `values`: `d` or,
/// for single precision, `s`, and the entries; or `!` and the error that ended the program there.
/// If it can compute no values at all it ends with status 3 and writes the reason to `complaint`:
/// `!` and an error, or `?` and another fault of the program or of its result.
struct Driver {
  std::string file_name;
  std::string text;
};

/// The text by which a driver, or its compiler, reports that the way to read an entry is unclear.
inline constexpr const char* entry_is_unclear = "assur_cannot_tell_how_an_entry_is_read";

[[nodiscard]] Driver driver_of(const UserProgram& program, const MatrixSize& size,
                               const PointTable& table);

/// Whether the file declares a function that the code calls with a parameter of type float.
[[nodiscard]] bool has_single_parameters(const std::string& file_text, const std::string& code);

}  // namespace assur::generator::audit::running
