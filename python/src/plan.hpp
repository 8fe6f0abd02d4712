// Scenes and plans, with the row layouts of their results, for Python.
#pragma once

#include <pybind11/pybind11.h>

#include <assur/mechanism/drawing.hpp>
#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <memory>

#include "layout.hpp"
#include "spare_values.hpp"

namespace assur::python {

/// A scene, and the text from which it was read, which a page solves anew.
struct ReadScene : mechanism::Scene {
  mechanism::SceneText source;
};
using SharedScene = std::shared_ptr<ReadScene>;

/// Reads a scene from text; errors name the file. Settings are those of parse_scene.
[[nodiscard]] SharedScene scene_of(const std::string& text, const std::string& file,
                                   const std::vector<std::string>& settings);

/// The scene in an argument. Throws TypeError for anything else.
[[nodiscard]] SharedScene scene_given(const pybind11::handle& value);

/// A plan, its scene, and the layouts of rows: of a configuration, and of the rates of the motions
/// through one.
struct PlannedScene {
  explicit PlannedScene(SharedScene of);

  SharedScene scene;
  mechanism::Plan plan;
  std::shared_ptr<const Layout> layout, layout_of_rates;
  SpareValues spare;
};

using SharedPlan = std::shared_ptr<PlannedScene>;
using PlanClass = pybind11::class_<PlannedScene, SharedPlan>;

// Each adds a method of plans for many values, and the classes of its results.
void add_solve_batch(pybind11::module_& module, PlanClass& plan);
void add_sweep(pybind11::module_& module, PlanClass& plan);

}  // namespace assur::python
