// A loaded scene with a joint of each sort.
#pragma once

#include <nlohmann/json.hpp>

namespace assur::test {

/// A four-bar that pushes a car, with a pin of three links, a slide, springs and a load that reads
/// a joint.
inline nlohmann::ordered_json mixed_scene() {
  return nlohmann::ordered_json::parse(R"json({
    "links": {"ground": {"A": [0, 0], "D": [4, 0], "rail": {"through": [0, -1], "along": [1, 0]}},
      "crank": {"A": [0, 0], "B": [1, 0]}, "rod": {"B": [0, 0], "C": [3, 0]},
      "rocker": {"D": [0, 0], "C": [2, 0]}, "strut": {"C": [0, 0], "E": [2.5, 0]},
      "car": {"E": [0, 0], "shoe": {"through": [0.3, 0], "along": [1, 0]}}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
      "B": {"type": "revolute", "between": ["crank.B", "rod.B"]},
      "C": {"type": "revolute", "between": ["rod.C", "rocker.C", "strut.C"]},
      "D": {"type": "revolute", "between": ["ground.D", "rocker.D"]},
      "E": {"type": "revolute", "between": ["strut.E", "car.E"]},
      "S": {"type": "prismatic", "between": ["ground.rail", "car.shoe"]}},
    "drivers": {"A": {"position": 1.1, "velocity": 2, "acceleration": 0.5}},
    "gravity": [0, -9.81],
    "parameters": {"load": 2, "sag": {"value": 0.2, "velocity": 0.5, "acceleration": -0.3}},
    "masses": {"rod": {"mass": "load", "at": [1.5, "sag"], "inertia": 0.3}, "car": {"mass": 5}},
    "loads": {"F": {"at": "car.E", "force": ["-3*joint(S)", "sin(joint(A))"]},
      "M": {
  "on" : "rocker", "moment" : "2*joint(D)"
}
}
, "springs" : {
  "T" : {"joint" : "A", "stiffness" : 2, "rest" : 0.5, "damping" : 0.1},
  "K" : {"between" : [ "ground.D", "strut.E" ], "stiffness" : 3, "length" : 0.5, "damping" : 0.2},
  "L" : {"joint" : "S", "stiffness" : 1, "rest" : 2, "damping" : 0.3}
},
              "want" : [ "position", "forces" ]
})json");
}

}  // namespace assur::test
