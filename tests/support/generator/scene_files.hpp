// Lists of the scene files in folders.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace assur::test {

inline std::set<std::filesystem::path> scene_files(const std::vector<std::string>& folders) {
  std::set<std::filesystem::path> scenes;
  for (const std::string& folder : folders) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".json") {
        scenes.insert(entry.path());
      }
    }
  }
  return scenes;
}

}  // namespace assur::test
