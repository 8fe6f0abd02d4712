// Reads an input file.
#pragma once

#include <filesystem>
#include <string>

namespace assur::text {

/// The whole text. Throws InputError if the file cannot be read, is larger than 8 MiB, or contains
/// a NUL byte.
[[nodiscard]] std::string read_input_file(const std::filesystem::path& file);

}  // namespace assur::text
