// Scenes of bars and pins named by their points, also in other listings.
#pragma once

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace assur::test {

/// Links are added with their points; points of one name on several links are a pin.
// NOLINTNEXTLINE(bugprone-exception-escape): destroying JSON throws only where memory is short
struct SceneMaker {
  using Json = nlohmann::ordered_json;  // keeps the order of insertion

  Json json;

  SceneMaker& parameter(const std::string& name, const Json& value) {
    json["parameters"][name] = value;
    return *this;
  }
  SceneMaker& point(const std::string& link, const std::string& name, const Json& x,
                    const Json& y) {
    json["links"][link][name] = Json::array({x, y});
    return *this;
  }
  SceneMaker& line(const std::string& link, const std::string& name, std::vector<double> through,
                   std::vector<double> along) {
    json["links"][link][name] = {{"through", std::move(through)}, {"along", std::move(along)}};
    return *this;
  }
  /// Points on the x-axis of a link, at these places.
  SceneMaker& bar(const std::string& link,
                  const std::vector<std::pair<std::string, Json>>& places) {
    for (const auto& [name, place] : places) {
      point(link, name, place, 0);
    }
    return *this;
  }
  SceneMaker& slide(const std::string& name, const std::string& first, const std::string& second) {
    return joint(name, "prismatic", {first, second});
  }
  SceneMaker& slot(const std::string& name, const std::string& first, const std::string& second) {
    return joint(name, "pin-in-slot", {first, second});
  }
  SceneMaker& drive(const std::string& name, const Json& position, double velocity,
                    double acceleration) {
    json["drivers"][name] = {
        {"position", position}, {"velocity", velocity}, {"acceleration", acceleration}};
    return *this;
  }
  SceneMaker& sweep(const std::string& name, double from, double to, int count) {
    json["sweep"] = {{"parameter", name}, {"from", from}, {"to", to}, {"count", count}};
    return *this;
  }

  /// The scene, with a pin and an output for the points of each name.
  [[nodiscard]] Json scene() const {
    Json result = json;
    std::map<std::string, std::vector<std::string>> places;
    for (const auto& [link, features] : json["links"].items()) {
      for (const auto& [name, feature] : features.items()) {
        if (feature.is_array()) {
          places[name].push_back(link + "." + name);
        }
      }
    }
    for (const auto& [name, features] : places) {
      result["outputs"][name] = features.front();
      if (features.size() > 1) {
        result["joints"][name] = {{"type", "revolute"}, {"between", features}};
      }
    }
    return result;
  }

 private:
  SceneMaker& joint(const std::string& name, const std::string& type,
                    std::vector<std::string> between) {
    json["joints"][name] = {{"type", type}, {"between", std::move(between)}};
    return *this;
  }
};

/// The number of listings of a scene: as it is, in reverse with the links of undriven pins
/// exchanged, and from the middle on.
inline constexpr int listings = 3;

inline SceneMaker::Json listed(const SceneMaker::Json& object, int listing) {
  std::vector<std::string> names;
  for (const auto& [name, value] : object.items()) {
    names.push_back(name);
  }
  if (listing == 1) {
    std::reverse(names.begin(), names.end());
  } else if (listing == 2) {
    std::rotate(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(names.size() / 2),
                names.end());
  }
  SceneMaker::Json result = SceneMaker::Json::object();
  for (const std::string& name : names) {
    result[name] = object[name];
  }
  return result;
}

inline SceneMaker::Json scene_listed(SceneMaker::Json scene, int listing) {
  for (const auto& [name, features] : scene["links"].items()) {
    features = listed(features, listing);
  }
  for (const auto& [name, joint] : scene["joints"].items()) {
    const bool is_driven = scene.contains("drivers") && scene["drivers"].contains(name);
    if (listing == 1 && !is_driven && joint["type"] == "revolute") {
      std::reverse(joint["between"].begin(), joint["between"].end());
    }
  }
  scene["links"] = listed(scene["links"], listing);
  scene["joints"] = listed(scene["joints"], listing);
  return scene;
}

}  // namespace assur::test
