// Scenes of bars with revolute joints, for tests of the decomposition into groups.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mechanism/scene_solutions.hpp"

namespace assur::test {

/// Bars of one length each between points of links, all by revolute joints.
class Bars {
 public:
  Bars() {
    scene_["parameters"]["phi"] = 0.7;
    scene_["links"]["ground"]["A"] = {0, 0};
    scene_["links"]["crank"] = {{"A", {0, 0}}, {"B", {1, 0}}};
    join("A", {"ground.A", "crank.A"});
    scene_["drivers"]["A"]["position"] = "phi";
  }
  Bars& point(const std::string& link, const std::string& name, double x, double y) {
    scene_["links"][link][name] = {x, y};
    return *this;
  }
  Bars& join(const std::string& name, const std::vector<std::string>& between) {
    scene_["joints"][name] = {{"type", "revolute"}, {"between", between}};
    return *this;
  }
  /// A crank-rocker: the dyad `coupler`, `rocker` with the joints B, C, D.
  Bars& four_bar() {
    point("ground", "D", 3, 0).point("coupler", "B", 0, 0).point("coupler", "C", 3, 0);
    point("coupler", "E", 1.5, 1).point("rocker", "D", 0, 0).point("rocker", "C", 2, 0);
    return join("B", {"crank.B", "coupler.B"})
        .join("C", {"coupler.C", "rocker.C"})
        .join("D", {"ground.D", "rocker.D"});
  }
  /// A bar with the points P at its origin and Q, by joints with names of their own.
  Bars& bar(const std::string& name, const std::string& from, const std::string& to) {
    point(name, "P", 0, 0).point(name, "Q", 3, 0);
    if (!from.empty()) {
      join(name + "_P", {from, name + ".P"});
    }
    return to.empty() ? *this : join(name + "_Q", {to, name + ".Q"});
  }
  Json& json() { return scene_; }

 private:
  Json scene_;
};

}  // namespace assur::test
