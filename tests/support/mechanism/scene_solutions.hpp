// Solutions and reports of scenes in JSON, with numbers in place of parameters' formulas.
#pragma once

#include <array>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mechanism/solved.hpp"

namespace assur::test {

using Json = nlohmann::ordered_json;

inline Json example(const std::string& name) {
  std::ifstream file(ASSUR_EXAMPLES "/" + name);
  return Json::parse(file);
}

inline Json worked() { return example("quintero_2011_rrp_rrr.json"); }

inline std::vector<std::string> parameter_names(const Json& scene) {
  std::vector<std::string> names;
  for (const auto& [name, value] : scene["parameters"].items()) {
    names.push_back(name);
  }
  return names;
}

/// A covariance of all parameters, which makes values carry second derivatives.
inline Json with_unit_covariance(Json scene) {
  const std::vector<std::string> names = parameter_names(scene);
  Json matrix = Json::array();
  for (std::size_t row = 0; row < names.size(); ++row) {
    matrix.push_back(std::vector<double>(names.size(), 0.0));
    matrix[row][row] = 1.0;
  }
  scene["covariance"] = {{"parameters", names}, {"matrix", matrix}};
  return scene;
}

/// `NAME=EXPR` that moves a parameter off its own law.
inline std::string setting(const Json& scene, const std::string& name, double offset) {
  const Json& entry = scene["parameters"][name];
  const Json& value = entry.is_object() ? entry["value"] : entry;
  std::array<char, 40> text{};
  (void)std::snprintf(text.data(), text.size(), ") + (%.17g)", offset);
  return name + "=(" + (value.is_string() ? value.get<std::string>() : value.dump()) + text.data();
}

inline Solved solved(const Json& json, const std::vector<std::string>& settings = {}) {
  return Solved(mechanism::parse_scene(json.dump(), "scene", settings));
}

/// Why a scene is refused.
inline std::string message_of(const Json& json) {
  try {
    (void)solved(json);
  } catch (const mechanism::InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The report of a scene as a program reads it.
inline Json report_of(const Json& json, const std::vector<std::string>& settings = {}) {
  return Json::parse(mechanism::report_json(solved(json, settings).report()));
}

}  // namespace assur::test
