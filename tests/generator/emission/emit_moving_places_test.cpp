// Law: where parameters have rates, an emitted solver moves what depends on them as `assur solve`
// does: points and lines on the ground and on links, lengths of groups, laws that read joints.
#include <gtest/gtest.h>

#include "generator/solver_comparison.hpp"
#include "whole_campaign.hpp"

namespace assur::test::emit_moving_places_test {
namespace {

using Json = nlohmann::ordered_json;

/// An example all of whose parameters move, each at rates of its own.
Json moving_example(const std::string& stem) {
  Json scene = scene_json(std::filesystem::path(ASSUR_EXAMPLES) / (stem + ".json"));
  double rate = 1;
  for (const auto& [name, parameter] : scene["parameters"].items()) {
    if (!parameter.is_object()) {
      parameter = Json{{"value", parameter}};
    }
    parameter["velocity"] = 0.3 * rate;
    parameter["acceleration"] = 0.2 - 0.1 * rate;
    rate = rate > 2 ? rate - 2.3 : rate + 0.7;
  }
  return scene;
}

/// All of the examples by `ctest -L long`; by default a crank's dyad and a rack.
TEST(EmitMovingPlaces, AgreesWithSolveWhereAllParametersMove) {
  const TemporaryDirectory directory;
  std::vector<EmittedScene> scenes;
  const std::vector<std::string> examples = {
      "four_bar_coupler_curve", "slider_crank",    "shaper_quick_return", "excavator_arm",
      "quintero_2011_rrp_rrr",  "geared_five_bar", "rack_press"};
  const std::size_t stride = is_whole_campaign() ? 1 : 6;
  for (std::size_t index = 0; index < examples.size(); index += stride) {
    const std::string& stem = examples[index];
    const auto file = directory.write(stem + ".json", moving_example(stem).dump());
    scenes.push_back({file, stem, struct_of(stem), {}});
  }
  for (const int compared : compare_with_solve(scenes)) {
    EXPECT_GT(compared, 100);
  }
}

/// A length whose value is a formula in another moving length, but whose rate is its own.
Json formula_with_its_own_rate() {
  Json scene = scene_json(std::filesystem::path(ASSUR_EXAMPLES) / "slider_crank.json");
  scene["parameters"]["crank"].update({{"value", "0.3*rod + 2*swell"}, {"velocity", 3}});
  scene["parameters"]["rod"].update({{"value", 160}, {"velocity", "swell"}, {"acceleration", -2}});
  scene["parameters"]["swell"] = {{"value", 1.5}, {"velocity", 0.5}, {"acceleration", 0.25}};
  return scene;
}

Json pin(const std::string& one, const std::string& other) {
  return {{"type", "revolute"}, {"between", Json::array({one, other})}};
}

/// A crank-rocker, and a dyad from its coupler to the ground. A law that reads the rocker's joint
/// shapes one link of the dyad: the length of a cylinder, or the angle between two bars.
Json shaped_by_law(const std::string& law, bool is_cylinder) {
  Json scene;
  scene["parameters"] = {{"reach", {{"value", 2.0}, {"tolerance", 0.01}}},
                         {"gain", {{"value", 0.3}, {"tolerance", 0.02}}}};
  scene["links"]["ground"] = {{"A", {0, 0}}, {"D", {3, 0}}, {"H", {4, 2}}};
  scene["links"]["crank"] = {{"A", {0, 0}}, {"B", {1, 0}}};
  scene["links"]["coupler"] = {{"B", {0, 0}}, {"C", {3, 0}}, {"E", {1.5, 1}}};
  scene["links"]["rocker"] = {{"D", {0, 0}}, {"C", {"reach", 0}}};
  scene["links"]["lever"] = {{"H", {0, 0}}, {"K", {2, 0}}, {"T", {1, 1}}};
  scene["joints"] = {{"A", pin("ground.A", "crank.A")},   {"B", pin("crank.B", "coupler.B")},
                     {"C", pin("coupler.C", "rocker.C")}, {"D", pin("ground.D", "rocker.D")},
                     {"E", pin("coupler.E", "tube.E")},   {"K", pin("rod.K", "lever.K")},
                     {"H", pin("ground.H", "lever.H")}};
  if (is_cylinder) {
    const Json axis = {{"through", {0, 0}}, {"along", {1, 0}}};
    scene["links"]["tube"] = {{"E", {0, 0}}, {"axis", axis}};
    scene["links"]["rod"] = {{"K", {0, 0}}, {"axis", axis}};
    scene["joints"]["S"] = {{"type", "prismatic"}, {"between", {"tube.axis", "rod.axis"}}};
  } else {
    scene["links"]["tube"] = {{"E", {0, 0}}, {"M", {1.5, 0}}};
    scene["links"]["rod"] = {{"K", {1.2, 0}}, {"M", {0, 0}}};
    scene["joints"]["S"] = pin("tube.M", "rod.M");
  }
  scene["drivers"] = {{"A", {{"position", 0.7}, {"velocity", 2}, {"acceleration", 1}}},
                      {"S", {{"position", law}}}};
  scene["outputs"] = {{"T", "lever.T"}};
  return scene;
}

/// The emitted code must declare the root after the coordinate that it reads.
Json law_with_a_root() {
  Json scene = scene_json(std::filesystem::path(ASSUR_EXAMPLES) / "rack_press.json");
  scene["drivers"]["rack"]["position"] = "pinion*sqrt(joint(D) + 4)";
  return scene;
}

/// A gear on the rocker or, if `is_slot`, a pin in a slot of the coupler with a dyad that follows.
/// The law drives the gear or the pin, and reads the rocker's joint.
Json driven_behind_its_group(const std::string& law, bool is_slot) {
  Json scene = shaped_by_law("1.6 + gain*joint(D)", true);
  if (is_slot) {
    scene["links"]["coupler"]["slot"] = {{"through", {0.5, 0.2}}, {"along", {1, 0.3}}};
    scene["links"]["follower"] = {{"P", {0, 0}}, {"Q", {2.5, 0}}};
    scene["links"]["guide"] = {{"Q", {0, 0}}, {"R", {2.2, 0}}};
    scene["links"]["ground"]["R"] = {2, -2};
    scene["joints"]["P"] = {{"type", "pin-in-slot"}, {"between", {"follower.P", "coupler.slot"}}};
    scene["joints"]["Q"] = pin("follower.Q", "guide.Q");
    scene["joints"]["R"] = pin("ground.R", "guide.R");
    scene["drivers"]["P"] = {{"position", law}};
    scene["outputs"]["Q"] = "guide.Q";
  } else {
    scene["links"]["gear"] = {{"C", {0, 0}}, {"G", {0.4, 0.1}}};
    scene["links"]["rocker"]["F"] = {1, 0.2};
    scene["joints"]["F"] = pin("rocker.F", "gear.C");
    scene["drivers"]["F"] = {{"position", law}};
    scene["outputs"]["G"] = "gear.G";
  }
  return scene;
}

/// Scenes in which laws that read joints shape later groups or contain a root, or in which a rate
/// is given in place of that of a formula. One program has them all, because they share most of its
/// compilation. By default it has one scene of each sort of law and joint.
TEST(EmitMovingPlaces, AgreesWithSolveOfLawsAndRatesOfTheirOwn) {
  const std::string turned = "0.5*joint(D)";
  const std::string bent = "0.4 + gain*joint(D)";
  const std::string rooted = "sqrt(2 + gain*joint(D)) + 0.1*joint(C)";
  std::vector<std::pair<std::string, Json>> named = {
      {"swelling", formula_with_its_own_rate()},
      {"bend", shaped_by_law(bent, false)},
      {"root", shaped_by_law(rooted, true)},
      {"slot", driven_behind_its_group("0.4 + 0.1*joint(D)", true)}};
  if (is_whole_campaign()) {
    named.insert(named.end(), {{"rooted", law_with_a_root()},
                               {"cylinder", shaped_by_law("1.6 + gain*joint(D)", true)},
                               {"gear", driven_behind_its_group(turned, false)}});
  }
  const TemporaryDirectory directory;
  std::vector<EmittedScene> scenes;
  for (const auto& [stem, scene] : named) {
    const auto file = directory.write(stem + ".json", scene.dump());
    scenes.push_back({file, stem, struct_of(stem), {}});
  }
  for (const int compared : compare_with_solve(scenes)) {
    EXPECT_GT(compared, 100);
  }
}

/// A sleeve with two pins in the slot of a rod, both moving, and a slider with two pins in a slot
/// of the ground, whose crank is as long as its rod; all slides are told, or the second pin alone.
Json two_pins_in_one_slot(bool is_sleeve, bool tells_second_alone) {
  const std::string link = is_sleeve ? "sleeve" : "slider";
  const std::string slot = is_sleeve ? "rod" : "ground";
  Json scene = {{"links",
                 {{"ground", {{"O", {0, 0}}}},
                  {"crank", {{"O", {0, 0}}, {"A", {1, 0}}}},
                  {"rod", {{"A", {0, 0}}, {"C", {1.25, 0}}}},
                  {link, {{"P", {-0.5, 0}}, {"Q", {1, 0}}, {"C", {0, 0}}}}}},
                {"drivers", {{"O", {{"position", 0.4}, {"velocity", 1}, {"acceleration", 0.5}}}}},
                {"outputs", {{"P", link + ".P"}}},
                {"want", {"position", "velocity", "acceleration"}}};
  scene["joints"]["O"] = pin("ground.O", "crank.O");
  if (is_sleeve) {
    scene["links"]["ground"]["D"] = {2.5, 0.25};
    scene["links"]["rod"] = {{"D", {0, 0}}};
    scene["joints"]["D"] = pin("ground.D", "rod.D");
    scene["joints"]["A"] = pin("crank.A", "sleeve.C");
  } else {
    scene["joints"]["A"] = pin("crank.A", "rod.A");
    scene["joints"]["C"] = pin("rod.C", "slider.C");
  }
  // The lines are one, told twice: the second from elsewhere and in the other sense.
  scene["links"][slot]["slot"] = {{"through", {0.25, 0}}, {"along", {2, 0}}};
  scene["links"][slot]["back"] = {{"through", {-1.5, 0}}, {"along", {-0.5, 0}}};
  for (const auto& [name, line] : {std::pair("Q", ".slot"), std::pair("P", ".back")}) {
    scene["joints"][std::string("S") + name] = {{"type", "pin-in-slot"},
                                                {"between", {link + "." + name, slot + line}}};
  }
  if (tells_second_alone) {
    scene["report"] = {{"joints", {"SQ"}}, {"links", Json::array()}};
  }
  return scene;
}

TEST(EmitMovingPlaces, AgreesWithSolveOfTwoPinsInOneSlot) {
  const TemporaryDirectory directory;
  std::vector<EmittedScene> scenes;
  for (const bool is_sleeve : {false, true}) {
    for (const bool tells_second_alone : {false, true}) {
      const std::string stem =
          std::string(is_sleeve ? "sleeve" : "slider") + (tells_second_alone ? "_second" : "_all");
      const auto file = directory.write(stem + ".json",
                                        two_pins_in_one_slot(is_sleeve, tells_second_alone).dump());
      scenes.push_back({file, stem, struct_of(stem), {}});
    }
  }
  for (const int compared : compare_with_solve(scenes)) {
    EXPECT_GT(compared, 10);
  }
}

}  // namespace
}  // namespace assur::test::emit_moving_places_test
