// Drawing and solution of an example, each computed once.
#pragma once

#include <assur/mechanism/drawing.hpp>
#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <map>
#include <memory>
#include <string>

namespace assur::test {

struct DrawnScene {
  explicit DrawnScene(const std::string& file)
      : scene(mechanism::read_scene(file)),
        plan(scene),
        values(plan.values()),
        solution(plan.solve(values)),
        drawing(drawing_of(scene.mechanism, scene.request)) {}

  mechanism::Scene scene;
  mechanism::Plan plan;
  mechanism::Values values;
  mechanism::Solution solution;
  mechanism::Drawing drawing;
};

inline const DrawnScene& drawn_scene(const std::string& name) {
  static std::map<std::string, std::unique_ptr<DrawnScene>> drawn;
  std::unique_ptr<DrawnScene>& one = drawn[name];
  if (!one) {
    one = std::make_unique<DrawnScene>(std::string(ASSUR_EXAMPLES) + "/" + name + ".json");
  }
  return *one;
}

}  // namespace assur::test
