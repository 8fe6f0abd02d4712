// A drag-link whose rocker winds up a spring, and the effort of its driver along each branch.
#pragma once

#include <assur/mechanism/forces.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <assur/mechanism/sweep.hpp>
#include <nlohmann/json.hpp>
#include <vector>

namespace assur::test {

/// A ground of 1, a crank of 3, a coupler of 3.2 and a rocker of 3.4, with a spring and a torque of
/// -3 times the angle at the rocker's pin, over two turns of the crank.
inline nlohmann::ordered_json turning_spring() {
  return nlohmann::ordered_json::parse(R"scene({
    "parameters": {"phi": 0.3},
    "links": {"ground": {"A": [0, 0], "D": [1, 0]}, "crank": {"A": [0, 0], "B": [3, 0]},
      "coupler": {"B": [0, 0], "C": [3.2, 0]}, "rocker": {"D": [0, 0], "C": [3.4, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
      "B": {"type": "revolute", "between": ["crank.B", "coupler.B"]},
      "C": {"type": "revolute", "between": ["coupler.C", "rocker.C"]},
      "D": {"type": "revolute", "between": ["ground.D", "rocker.D"]}},
    "drivers": {"A": {"position": "phi"}},
    "springs": {"S": {"joint": "D", "stiffness": 2, "rest": 0.2}},
    "loads": {"T": {"on": "rocker", "moment": "-3*joint(D)"}},
    "want": ["position", "forces"],
    "sweep": {"parameter": "phi", "from": 0.3, "to": "0.3 + 4*pi", "count": 721}})scene");
}

/// The driver's effort in each row of a branch.
inline std::vector<double> efforts_along(const nlohmann::ordered_json& json, std::size_t branch) {
  const mechanism::Scene scene = mechanism::parse_scene(json.dump(), "scene.json");
  const mechanism::Plan plan(scene.mechanism, scene.request);
  mechanism::Values values = plan.values();
  std::vector<double> efforts;
  (void)mechanism::sweep_branch(
      plan, branch,
      {[&](const mechanism::SweepRecord& record) {
         values.set(plan.request().sweep->parameter, record.parameter);
         efforts.push_back(mechanism::forces_of(values, *record.state).efforts.items().front());
       },
       nullptr, nullptr});
  return efforts;
}

}  // namespace assur::test
