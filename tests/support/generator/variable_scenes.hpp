// Scenes of mechanisms whose dimensions are parameters, with admissible values.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "mechanism/scene_maker.hpp"

namespace assur::test::variable {

using Json = SceneMaker::Json;
using Values = std::map<std::string, double>;

struct VariableScene {
  std::string name;  ///< of the file; the solver is named after it
  std::string solver;
  Json json;
  std::vector<Values> values;  ///< of all variable parameters
  std::string variable = "all";
};

/// A four-bar with a point off the coupler's line, and a length that is a formula.
inline VariableScene four_bar() {
  SceneMaker scene;
  scene.parameter("ground", 4)
      .parameter("crank", {{"value", 2}, {"tolerance", 0.01}})
      .parameter("coupler", 3)
      .parameter("rocker", 3.5)
      .parameter("reach", "2*coupler")
      .parameter("bend", "20*deg")
      .bar("ground", {{"A", 0}, {"D", "ground"}})
      .bar("crank", {{"A", 0}, {"B", "crank"}})
      .bar("coupler", {{"B", 0}, {"C", "coupler"}})
      .point("coupler", "P", "reach*cos(bend)", "reach*sin(bend)")
      .bar("rocker", {{"D", 0}, {"C", "rocker"}})
      .drive("A", 0.7, 1.5, 0.5);
  const auto lengths = [](double ground, double crank, double coupler, double rocker, double bend) {
    return Values{{"ground", ground},
                  {"crank", crank},
                  {"coupler", coupler},
                  {"rocker", rocker},
                  {"bend", bend}};
  };
  return {"variable_four_bar",
          "VariableFourBar",
          scene.scene(),
          {lengths(4, 2, 3, 3.5, 0.349), lengths(3, 2, 3, 2, 0), lengths(-4, 2, -3, 3.5, -1),
           lengths(40, 20, 30, 35, 0.1), lengths(4, 1e-3, 3, 3.5, 0.349),
           lengths(9, 2, 3, 3.5, 0.349)}};
}

/// A crank whose pin runs in a slot of the rocker, which is turned and off the rocker's pivot.
inline VariableScene quick_return() {
  SceneMaker scene;
  scene.parameter("height", 3)
      .parameter("turn", 0.3)
      .parameter("offset", 0.4)
      .parameter("crank", 1)
      .point("ground", "A", 0, 0)
      .point("ground", "O", "height/10", "height")
      .bar("crank", {{"O", 0}, {"B", "crank"}})
      .point("rocker", "A", 0, 0)
      .point("rocker", "T", 5, "offset")
      .drive("O", 0.6, 1, 0.5);
  scene.json["links"]["rocker"]["slot"] = {{"through", {0, "offset"}},
                                           {"along", {"cos(turn)", "sin(turn)"}}};
  scene.slot("S", "rocker.slot", "crank.B");
  const auto values = [](double height, double turn, double offset, double crank) {
    return Values{{"height", height}, {"turn", turn}, {"offset", offset}, {"crank", crank}};
  };
  return {"variable_quick_return",
          "VariableQuickReturn",
          scene.scene(),
          {values(3, 0.3, 0.4, 1), values(3, 0, 0, 1), values(-2, 2.9, -0.3, 1.2),
           values(4, 0.3, 9, 1)}};
}

/// A platform on three legs whose corners are anywhere.
inline VariableScene platform() {
  SceneMaker scene;
  scene.parameter("size", {{"value", 1}, {"tolerance", 0.1}})
      .parameter("slant", 0.25)
      .parameter("leg", 2.5)
      .parameter("base", 4);
  const std::array<std::array<std::string, 2>, 3> corners{
      {{"0", "0"}, {"2*size", "slant"}, {"size", "1.5*size"}}};
  const std::array<std::array<std::string, 2>, 3> feet{
      {{"0", "0"}, {"base", "0"}, {"base/2", "3+slant"}}};
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    const std::string number = std::to_string(corner);
    scene.point("ground", "G" + number, feet[corner][0], feet[corner][1])
        .point("platform", "P" + number, corners[corner][0], corners[corner][1])
        .bar("leg" + number, {{"G" + number, 0}, {"P" + number, "leg"}});
  }
  return {"variable_platform",
          "VariablePlatform",
          scene.scene(),
          {{{"size", 1}, {"slant", 0.25}, {"leg", 2.5}, {"base", 4}},
           {{"size", 1.25}, {"slant", -0.5}, {"leg", 2}, {"base", 5}},
           {{"size", 0.5}, {"slant", 0.125}, {"leg", 3}, {"base", 4}}}};
}

/// The platform on three legs, whose pivot P1 may be anywhere, even at P0 or P2.
inline VariableScene meeting_pivots() {
  SceneMaker scene;
  scene.parameter("a", 1).parameter("b", 0.5);
  scene.point("platform", "P0", 0, 0).point("platform", "P1", "a", "b");
  scene.point("platform", "P2", 0.5, 1.25);
  scene.point("ground", "G0", 0, 0).point("ground", "G1", 4, 0).point("ground", "G2", 2, 3.25);
  for (const std::string number : {"0", "1", "2"}) {
    scene.bar("leg" + number, {{"G" + number, 0}, {"P" + number, 2.5}});
  }
  return {"variable_meeting_pivots",
          "VariableMeetingPivots",
          scene.scene(),
          {{{"a", 1}, {"b", 0.5}},
           {{"a", 0}, {"b", 0}},
           {{"a", 0.5}, {"b", 1.25}},
           {{"a", -0.25}, {"b", 0}}}};
}

/// A link on three slides of which two are parallel, at a variable distance.
inline VariableScene parallel_slides() {
  SceneMaker scene;
  scene.parameter("distance", 1.5).parameter("turn", 1.2).parameter("place", 2);
  scene.point("ground", "P0", 0, 0).point("ground", "P1", 0.5, 2).point("ground", "P2", "place", 1);
  scene.json["links"]["frame"] = {
      {"s0", {{"through", {0, 0}}, {"along", {1, 0}}}},
      {"s1", {{"through", {0, "distance"}}, {"along", {2, 0}}}},
      {"s2", {{"through", {1, 0}}, {"along", {"cos(turn)", "sin(turn)"}}}}};
  for (const std::string number : {"0", "1", "2"}) {
    scene.slot("S" + number, "frame.s" + number, "ground.P" + number);
  }
  return {"variable_parallel_slides",
          "VariableParallelSlides",
          scene.scene(),
          {{{"distance", 1.5}, {"turn", 1.2}, {"place", 2}},
           {{"distance", -1}, {"turn", -0.4}, {"place", 1}},
           {{"distance", 2.5}, {"turn", 1.2}, {"place", 2}}}};
}

/// A link on three slides whose directions vary; at the scene's own values they cross.
inline VariableScene turning_slides() {
  SceneMaker scene;
  scene.parameter("turn", 0.3).parameter("other", 1.2).parameter("distance", 1.5);
  scene.point("ground", "P0", 0, 0).point("ground", "P1", 0.5, 2).point("ground", "P2", 2, 1);
  scene.json["links"]["frame"] = {
      {"s0", {{"through", {0, 0}}, {"along", {1, 0}}}},
      {"s1", {{"through", {0, "distance"}}, {"along", {"cos(turn)", "sin(turn)"}}}},
      {"s2", {{"through", {1, 0}}, {"along", {"cos(other)", "sin(other)"}}}}};
  for (const std::string number : {"0", "1", "2"}) {
    scene.slot("S" + number, "frame.s" + number, "ground.P" + number);
  }
  const auto values = [](double turn, double other) {
    return Values{{"turn", turn}, {"other", other}, {"distance", 1.5}};
  };
  return {"variable_turning_slides",
          "VariableTurningSlides",
          scene.scene(),
          {values(0.3, 1.2), values(0, 1.2), values(1e-8, 1.2), values(3.141592653589793, 1.2),
           values(0.3, 0), values(0.3, 0.3)}};
}

/// A four-bar whose coupler is drawn far from the origin. Its rocker is named like a root in
/// emitted code, and has a coordinate that is the root of a parameter that has a tolerance and does
/// not vary.
inline VariableScene drawn_bars() {
  SceneMaker scene;
  scene.parameter("bx", 500)
      .parameter("by", 800)
      .parameter("cx", 503)
      .parameter("cy", 800.5)
      .parameter("area", {{"value", 10}, {"tolerance", 0.1}})
      .parameter("rise", 1)
      .bar("ground", {{"A", 0}, {"D", 4}})
      .bar("crank", {{"A", 0}, {"B", 2}})
      .point("coupler", "B", "bx", "by")
      .point("coupler", "C", "cx", "cy")
      .point("coupler", "P", "bx+1", "by+(cx-bx)^3/20")
      .point("root_1", "D", 0, 0)
      .point("root_1", "C", "sqrt(area)", "rise")
      .drive("A", 0.7, 1.5, 0.5);
  const auto values = [](double bx, double cy, double rise) {
    return Values{{"bx", bx}, {"by", 800}, {"cx", 503}, {"cy", cy}, {"rise", rise}};
  };
  return {"variable_drawn_bars",
          "VariableDrawnBars",
          scene.scene(),
          {values(500, 800.5, 1), values(500.25, 799.5, -0.5)},
          "bx,by,cx,cy,rise"};
}

inline Json with_values(Json scene, const Values& values) {
  for (const auto& [name, value] : values) {
    Json& parameter = scene["parameters"][name];
    (parameter.is_object() ? parameter["value"] : parameter) = value;
  }
  return scene;
}

}  // namespace assur::test::variable
