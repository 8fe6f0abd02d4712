// Turns the parts of a scene's JSON into those of the scene, each from the parts before it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "scene/json_values.hpp"

namespace assur::generator {

/// The names of links, joints, parameters and the like.
template <typename Items>
[[nodiscard]] std::vector<std::string> names_of(const Items& items) {
  std::vector<std::string> names;
  names.reserve(items.size());
  for (const auto& item : items) {
    names.push_back(item.name);
  }
  return names;
}

/// Which of them has a name; -1: none.
template <typename Items>
[[nodiscard]] int index_of(const Items& items, const std::string& name) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
  return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

/// The feature that `link.feature` names.
[[nodiscard]] FeatureReference feature_reference(const SceneJson& value, const std::string& where,
                                                 const JsonValues& values, const Scene& scene);

/// Reads links, joints and drivers.
void read_linkage(const SceneJson& root, const JsonValues& values, Scene& scene);
/// Reads what is asked of them: outputs, want, sweep and covariance.
void read_requests(const SceneJson& root, const JsonValues& values, Scene& scene);

}  // namespace assur::generator
