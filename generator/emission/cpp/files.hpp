// Turns emitted text into the files of a directory, or compares it with what is there.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace assur::generator::emission::cpp {

/// A file to be written: its path below the output directory, and its text.
struct EmittedFile {
  std::filesystem::path path;
  std::string text;
};

/// Writes the files. Each is written beside its place, and all are moved there when the last one is
/// written, so that no file is ever half-written and a full disk leaves the old files. Throws
/// InputError if the directory cannot be written, or if a directory or the solver of another scene
/// is in the place of a file.
void write_files(const std::vector<EmittedFile>& files, const std::filesystem::path& directory);
/// The files that are missing or differ in `directory`.
[[nodiscard]] std::vector<std::filesystem::path> differing_files(
    const std::vector<EmittedFile>& files, const std::filesystem::path& directory);

}  // namespace assur::generator::emission::cpp
