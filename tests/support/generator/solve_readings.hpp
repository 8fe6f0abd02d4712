// The numbers in a report of `assur solve`, each with the C++ that reads the same number from the
// scene's emitted solver.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "command/command.hpp"

namespace assur::test {

/// Steps of the drivers from their positions in the scene.
inline const std::vector<double> driver_steps = {0, 0.05, -0.11, 0.31};

/// A scene with an emitted solver, and its names there.
struct EmittedScene {
  std::filesystem::path file;
  std::string header;                          ///< below assur/scenes, without extension
  std::string solver;                          ///< the struct
  std::map<std::string, std::string> members;  ///< of names that differ from their members

  [[nodiscard]] std::string member(const std::string& name) const {
    const auto found = members.find(name);
    return found == members.end() ? name : found->second;
  }
};

inline nlohmann::ordered_json scene_json(const std::filesystem::path& file) {
  return nlohmann::ordered_json::parse(read_file(file));
}

/// One number of a configuration: its sort, the C++ that reads it, and its value.
struct Reading {
  std::string sort;
  std::string code;
  double value;
};

/// Lists what `assur solve` says of a configuration.
class ReadingList {
 public:
  using Json = nlohmann::ordered_json;

  explicit ReadingList(const EmittedScene& scene) : scene_(scene), json_(scene_json(scene.file)) {}

  std::vector<Reading> read(const Json& configuration) {
    readings_.clear();
    for (const auto& [name, link] : configuration["links"].items()) {
      if (name != "ground") {
        read_link("s.links." + scene_.member(name) + ".", link);
      }
    }
    for (const auto& [name, slide] : configuration["joints"].items()) {
      for (const std::string what : {"displacement", "velocity", "acceleration"}) {
        if (slide.contains(what)) {  // forces are read elsewhere
          const std::string sort = what == "displacement" ? "length" : what;
          readings_.push_back({sort, "s.slides." + scene_.member(name) + "." + what, slide[what]});
        }
      }
    }
    for (const auto& [name, output] : configuration["outputs"].items()) {
      read_output("s.outputs." + scene_.member(name) + ".", output);
    }
    readings_.push_back({"regularity", "s.regularity == assur::Status::ok ? 1.0 : 0.0",
                         configuration["regularity"] == "regular" ? 1.0 : 0.0});
    return readings_;
  }

 private:
  void read_vector(const std::string& sort, const std::string& code, const Json& values) {
    for (std::size_t index = 0; index < values.size(); ++index) {
      readings_.push_back({sort, code + "(" + std::to_string(index) + ")", values[index]});
    }
  }

  void read_link(const std::string& member, const Json& link) {
    if (link.contains("theta")) {
      readings_.push_back({"length", member + "pose.x", link["x"]});
      readings_.push_back({"length", member + "pose.y", link["y"]});
      const double theta = link["theta"];
      readings_.push_back({"direction", member + "pose.direction.cos", std::cos(theta)});
      readings_.push_back({"direction", member + "pose.direction.sin", std::sin(theta)});
    }
    for (const std::string rate : {"velocity", "acceleration"}) {
      if (link.contains(rate)) {
        const Json& values = link[rate];
        read_vector(rate, member + rate, {values[0], values[1]});
        readings_.push_back({"angular " + rate, member + rate + "(2)", values[2]});
      }
    }
  }

  void read_output(const std::string& member, const Json& output) {
    std::vector<std::string> vectors = {"position", "velocity", "acceleration"};
    if (has_tolerances()) {
      vectors.insert(vectors.end(), {"worst_case", "rss"});
    }
    for (const std::string& what : vectors) {
      if (output.contains(what)) {
        read_vector(what == "position" ? "length" : what, member + what, output[what]);
      }
    }
    if (output.contains("sensitivity")) {
      for (const auto& [parameter, pair] : output["sensitivity"].items()) {
        for (int row = 0; row < 2; ++row) {
          readings_.push_back({"sensitivity to " + parameter,
                               "sensitivity<S>(" + member + "sensitivity, \"" + parameter + "\", " +
                                   std::to_string(row) + ")",
                               pair[static_cast<std::size_t>(row)]});
        }
      }
    }
  }

  /// Whether a parameter has a tolerance; otherwise the solver has no results on tolerances.
  [[nodiscard]] bool has_tolerances() const {
    const Json parameters = json_.value("parameters", Json::object());
    return std::any_of(parameters.begin(), parameters.end(), [](const Json& parameter) {
      return parameter.is_object() && parameter.contains("tolerance");
    });
  }

  const EmittedScene& scene_;
  Json json_;
  std::vector<Reading> readings_;
};

/// Whether a driver's law reads no other joint: then its position is an argument of the solver.
inline bool is_argument(const nlohmann::ordered_json& driver) {
  const nlohmann::ordered_json& position = driver["position"];
  return !position.is_string() || position.get<std::string>().find("joint(") == std::string::npos;
}

/// The scene with every driver that is an argument moved on by a step.
inline nlohmann::ordered_json stepped(nlohmann::ordered_json scene, double step) {
  if (!scene.contains("drivers")) {
    return scene;
  }
  for (const auto& [name, driver] : scene["drivers"].items()) {
    if (!is_argument(driver)) {
      continue;
    }
    const nlohmann::ordered_json position = driver["position"];
    const std::string text = position.is_string() ? position.get<std::string>() : position.dump();
    std::ostringstream moved;
    moved.precision(17);
    moved << "(" << text << ") + (" << step << ")";
    driver["position"] = moved.str();
  }
  return scene;
}

/// The readings of every configuration that `assur solve` finds: [step][configuration].
using SolveReadings = std::vector<std::vector<std::vector<Reading>>>;

inline SolveReadings solve_readings(const EmittedScene& scene) {
  const TemporaryDirectory directory;
  SolveReadings result;
  for (const double step : driver_steps) {
    const auto file = directory.write("stepped.json", stepped(scene_json(scene.file), step).dump());
    const CommandResult solved = run_assur("solve " + file.string() + " --format json");
    EXPECT_EQ(solved.status, 0) << scene.file << " at " << step << ": " << solved.messages;
    auto& configurations = result.emplace_back();
    if (solved.status != 0) {
      continue;
    }
    const auto root = nlohmann::ordered_json::parse(solved.output);
    for (const auto& configuration : root["configurations"]) {
      configurations.push_back(ReadingList(scene).read(configuration));
    }
  }
  return result;
}

}  // namespace assur::test
