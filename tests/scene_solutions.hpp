// Turns scenes as JSON, with parameters moved off their laws, into solutions and reports.
#pragma once

#include <array>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scene/report.hpp"

namespace assur::test {

using generator::AssemblyConfiguration;
using generator::Dual;
using generator::ParameterValues;
using generator::Scene;
using generator::Solution;
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

inline Solution solution_of(const Json& json, const std::vector<std::string>& settings = {}) {
  const Scene scene = generator::parse_scene(json.dump(), "scene", settings);
  return generator::solve(scene, ParameterValues(scene));
}

/// The report of a scene as a program reads it.
inline Json report_of(const Json& json, const std::vector<std::string>& settings = {}) {
  const Scene scene = generator::parse_scene(json.dump(), "scene", settings);
  const ParameterValues values(scene);
  const Solution solution = generator::solve(scene, values);
  return Json::parse(generator::report_json({&scene, &values, &solution}));
}

/// All that a configuration says of positions.
inline std::vector<Dual> coordinates(const AssemblyConfiguration& configuration) {
  std::vector<Dual> result;
  for (const auto& link : configuration.links) {
    result.insert(result.end(), {link.x, link.y, angle_of(link.direction)});
  }
  for (const auto& joint : configuration.joints) {
    result.push_back(joint.displacement);
  }
  for (const auto& point : configuration.outputs) {
    result.insert(result.end(), {point.x, point.y});
  }
  return result;
}

}  // namespace assur::test
