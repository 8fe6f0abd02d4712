// Reads a mechanism and its request from a scene file (JSON).
#pragma once

#include <assur/mechanism/drawn_mechanism.hpp>
#include <assur/mechanism/request.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace assur::mechanism {

/// The content of a scene file, and the name of the file, with which messages begin.
struct Scene {
  std::string file;
  Mechanism mechanism;
  Request request;
  Table<DrawnPointIndex, DrawnPoint> points = {};  ///< of the drawing, if there is one
};

/// Reads a scene. `settings` replace parameters' values: `NAME=EXPR`; messages call them
/// `settings_name`. Throws InputError with one line: the file, the place, the fault, and the remedy
/// if there is one.
[[nodiscard]] Scene read_scene(const std::filesystem::path& file,
                               const std::vector<std::string>& settings = {},
                               const std::string& settings_name = "settings");
/// The same from text; `file` is its name in messages.
[[nodiscard]] Scene parse_scene(const std::string& text, const std::string& file,
                                const std::vector<std::string>& settings = {},
                                const std::string& settings_name = "settings");

/// The JSON Schema (draft 2020-12) of scenes: every key of the format, with its meaning.
[[nodiscard]] std::string scene_schema();

}  // namespace assur::mechanism
