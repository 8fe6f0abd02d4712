// Adds masses, loads and springs to a scene wherever possible.
#pragma once

#include <nlohmann/json.hpp>
#include <random>
#include <string>

namespace assur::test {

/// Loads everything of a scene that can be loaded, by whole numbers.
inline nlohmann::ordered_json loaded(const nlohmann::ordered_json& bare, unsigned seed) {
  nlohmann::ordered_json scene = bare;
  std::mt19937 engine(seed);
  const auto number = [&](int low, int high) {
    return low + static_cast<int>(engine() % static_cast<unsigned>(high - low + 1));
  };
  scene["gravity"] = {number(-2, 2), -9.81};
  std::string before;
  for (const auto& [link, features] : bare["links"].items()) {
    scene["masses"][link] = {
        {"mass", number(0, 3)}, {"at", {number(-2, 2), number(-2, 2)}}, {"inertia", number(0, 2)}};
    scene["loads"]["M" + link] = {{"on", link}, {"moment", number(-3, 3)}};
    for (const auto& [name, feature] : features.items()) {
      if (!feature.is_array()) {
        continue;
      }
      const std::string point = link + "." + name;
      scene["loads"]["F" + point] = {{"at", point}, {"force", {number(-3, 3), number(-3, 3)}}};
      if (number(0, 1) == 1) {
        scene["loads"]["F" + point]["frame"] = link;
      }
      const auto joint_of = [](const std::string& of) { return of.substr(0, of.find('_')); };
      if (!before.empty() && before.substr(0, before.find('.')) != link &&
          joint_of(before.substr(before.find('.') + 1)) != joint_of(name)) {  // not at one pin
        scene["springs"]["K" + point] = {{"between", {before, point}},
                                         {"stiffness", number(0, 3)},
                                         {"length", number(0, 2)},
                                         {"damping", number(0, 1)}};
      }
      before = point;
    }
  }
  for (const auto& [joint, entry] : bare["joints"].items()) {
    if (entry["between"].size() == 2) {
      scene["springs"]["T" + joint] = {
          {"joint", joint}, {"stiffness", number(0, 2)}, {"rest", number(-1, 1)}};
    }
  }
  scene["want"] = {"position", "velocity", "acceleration", "forces", "dynamics", "coefficients"};
  return scene;
}

}  // namespace assur::test
