// A scene whose names are not identifiers of C++, for the tests of emitted solvers.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "generator/solve_readings.hpp"

namespace assur::test {

inline nlohmann::ordered_json renamed_keys(const nlohmann::ordered_json& object,
                                           const std::map<std::string, std::string>& names) {
  nlohmann::ordered_json result = nlohmann::ordered_json::object();
  for (const auto& [name, value] : object.items()) {
    const auto found = names.find(name);
    result[found == names.end() ? name : found->second] = value;
  }
  return result;
}

inline void rename_link(nlohmann::ordered_json& reference,
                        const std::map<std::string, std::string>& links) {
  const std::string text = reference;
  const std::size_t dot = text.find('.');
  const auto found = links.find(text.substr(0, dot));
  if (found != links.end()) {
    reference = found->second + text.substr(dot);
  }
}

/// The rack press with names that are no identifiers, are keywords, are words of the solver, or
/// become equal.
inline nlohmann::ordered_json awkward_scene() {
  const std::map<std::string, std::string> links = {
      {"crank", "class"}, {"rod", "1-2"}, {"lever", "1 2"}, {"ram", "slide_S"}};
  const std::map<std::string, std::string> joints = {
      {"A", "1-2"}, {"rack", "class"}, {"ram", "S"}, {"K", " "}, {"M", "\"D\\"}};
  nlohmann::ordered_json scene =
      scene_json(std::filesystem::path(ASSUR_EXAMPLES) / "rack_press.json");
  for (const auto& [name, joint] : scene["joints"].items()) {
    for (nlohmann::ordered_json& reference : joint["between"]) {
      rename_link(reference, links);
    }
  }
  for (const auto& [name, reference] : scene["outputs"].items()) {
    rename_link(reference, links);
  }
  scene["name"] = "a <b> & \"c\" {{file}} \\";
  scene["links"] = renamed_keys(scene["links"], links);
  scene["joints"] = renamed_keys(scene["joints"], joints);
  scene["drivers"] = renamed_keys(scene["drivers"], joints);
  scene["outputs"] = renamed_keys(scene["outputs"], {{"R", "\u00e9\n"}, {"M", "__Drivers"}});
  return scene;
}

}  // namespace assur::test
