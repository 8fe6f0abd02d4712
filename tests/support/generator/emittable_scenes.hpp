// Turns folders of scenes into those that an emitted solver can model.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace assur::test {

/// All scenes but those with groups that are solved relative to moving links.
inline std::set<std::filesystem::path> emittable_scenes(const std::vector<std::string>& folders) {
  std::set<std::filesystem::path> scenes;
  for (const std::string& folder : folders) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".json" &&
          !mechanism::Plan(mechanism::read_scene(entry.path().string()))
               .structure()
               .has_relative_groups()) {
        scenes.insert(entry.path());
      }
    }
  }
  return scenes;
}

}  // namespace assur::test
