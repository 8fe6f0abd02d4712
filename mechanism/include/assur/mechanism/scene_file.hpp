// Turns a scene file (JSON) into a mechanism and what is wanted of it.
#pragma once

#include <assur/mechanism/drawn_mechanism.hpp>
#include <assur/mechanism/request.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace assur::mechanism {

/// What a scene file holds, and the name of the file, which messages begin with.
struct Scene {
  std::string file;
  Mechanism mechanism;
  Request request;
  Table<DrawnPointIndex, DrawnPoint> points = {};  ///< of the drawing, if there is one
};

/// Reads a scene. `settings` replace parameters' values: `NAME=EXPR`; messages call them
/// `settings_name`. Throws InputError with one line: file, place, what is wrong, and the remedy
/// where there is one.
[[nodiscard]] Scene read_scene(const std::filesystem::path& file,
                               const std::vector<std::string>& settings = {},
                               const std::string& settings_name = "settings");
/// The same from text; `file` is its name in messages.
[[nodiscard]] Scene parse_scene(const std::string& text, const std::string& file,
                                const std::vector<std::string>& settings = {},
                                const std::string& settings_name = "settings");

/// The JSON Schema (draft 2020-12) of scenes: every key that the reader knows, and what it means.
[[nodiscard]] std::string scene_schema();

}  // namespace assur::mechanism
