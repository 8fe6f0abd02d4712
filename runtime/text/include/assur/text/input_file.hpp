// Turns a file that the user names into its text.
#pragma once

#include <filesystem>
#include <string>

namespace assur::text {

/// The whole text. Throws InputError where there is no file to read, one of more than 8 MiB, or one
/// with a NUL byte.
[[nodiscard]] std::string read_input_file(const std::filesystem::path& file);

}  // namespace assur::text
