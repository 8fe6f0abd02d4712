// Turns models into the C++ files of a directory, or compares them with what is there.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "structure/kind.hpp"

namespace assur::generator {

/// A file to be: its path below the output directory, and its text.
struct EmittedFile {
  std::filesystem::path path;
  std::string text;
};

/// The header of one model: `assur/tetrad/model_02.hpp`.
[[nodiscard]] EmittedFile emit_model(const Model& model);
/// The headers of every model of every group, and the lists of models.
[[nodiscard]] std::vector<EmittedFile> emit_all();

/// Writes the files. Each is written beside its place and then moved there, so that none is ever
/// half-written. Throws InputError if the directory cannot be written.
void write_files(const std::vector<EmittedFile>& files, const std::filesystem::path& directory);
/// The files that are missing or differ in `directory`.
[[nodiscard]] std::vector<std::filesystem::path> differing_files(
    const std::vector<EmittedFile>& files, const std::filesystem::path& directory);

}  // namespace assur::generator
