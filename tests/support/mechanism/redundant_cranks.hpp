// Scenes of parallel cranks of equal length with their couplers, from the pivots.
#pragma once

#include <assur/mechanism/sweep.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "mechanism/solved.hpp"

namespace assur::test {

struct Place {
  double x, y;
};

/// Cranks that hold one coupler, then others that hold another; more than two over-constrain it.
class RedundantCranks {
 public:
  using Json = nlohmann::ordered_json;  // keeps the order of insertion

  explicit RedundantCranks(double length) : length_(length) {}

  /// Adds a crank; its tip has the same coordinates on the coupler as its pivot on the ground.
  RedundantCranks& add(const std::string& name, Place pivot) {
    scene_["links"]["ground"][name] = {pivot.x, pivot.y};
    scene_["links"][coupler_][name] = {pivot.x, pivot.y};
    scene_["links"]["crank " + name] = {{"pivot", {0, 0}}, {"tip", {length_, 0}}};
    join(name, "ground." + name, "crank " + name + ".pivot");
    join(name + " tip", "crank " + name + ".tip", coupler_ + "." + name);
    return *this;
  }
  RedundantCranks& drive(const std::string& crank) {
    scene_["drivers"][crank] = {{"position", "phi"}, {"velocity", 1}};
    return *this;
  }
  /// The cranks that are added after this hold the coupler of this name.
  RedundantCranks& begin(const std::string& coupler) {
    coupler_ = coupler;
    return *this;
  }
  [[nodiscard]] Plan planned(double phi) {
    scene_["parameters"]["phi"] = phi;
    return Plan(mechanism::parse_scene(scene_.dump(), "scene"));
  }
  [[nodiscard]] Json& json() { return scene_; }

 private:
  void join(const std::string& name, const std::string& one, const std::string& other) {
    scene_["joints"][name] = {{"type", "revolute"}, {"between", {one, other}}};
  }

  double length_;
  std::string coupler_ = "coupler";
  Json scene_;
};

}  // namespace assur::test
