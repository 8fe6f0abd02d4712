// Writes emitted files into a directory, or compares them with those that it contains.
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

/// Writes the files. Each is written beside its target, and all are renamed when the last one is
/// complete, so that no file is ever half-written and a full disk leaves the old files. Throws
/// InputError if the directory cannot be written, or if a file's target is a directory or the
/// solver of another scene.
void write_files(const std::vector<EmittedFile>& files, const std::filesystem::path& directory);
/// The files that are missing or differ in `directory`.
[[nodiscard]] std::vector<std::filesystem::path> differing_files(
    const std::vector<EmittedFile>& files, const std::filesystem::path& directory);

}  // namespace assur::generator::emission::cpp
