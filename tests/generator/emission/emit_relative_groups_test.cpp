// Law: an emitted solver agrees with `assur solve` if groups are solved relative to moving links:
// positions, rates of every order and sensitivities, whatever such links carry.
#include <gtest/gtest.h>

#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>

#include "generator/solver_comparison.hpp"
#include "mechanism/random_driven_scene.hpp"
#include "mechanism/scene_maker.hpp"
#include "whole_campaign.hpp"

namespace assur::test::emit_relative_groups_test {
namespace {

using Json = nlohmann::ordered_json;

struct NamedScene {
  std::string name;
  std::string solver;
  Json json;
};

/// A four-bar whose coupler is a triangle of bars, one of which grows.
SceneMaker truss() {
  SceneMaker scene;
  scene.parameter("side", {{"value", 2}, {"tolerance", 0.01}})
      .parameter("swell", {{"value", 1.5}, {"velocity", 0.3}, {"acceleration", -0.2}})
      .bar("ground", {{"A", 0}, {"D", 3}})
      .bar("crank", {{"A", 0}, {"B", 1}})
      .bar("rocker", {{"D", 0}, {"S", 2}})
      .bar("one", {{"X", 0}, {"Z", "side"}})
      .point("one", "B", -1, 0.5)
      .bar("two", {{"X", 0}, {"Y", 2}})
      .point("two", "S", 1, 0.3)
      .bar("three", {{"Y", 0}, {"Z", "swell"}})
      .drive("A", 0.7, 1.3, 0.4);
  return scene;
}

/// The truss with a driven cylinder in place of its third bar: a group that is solved relative to
/// one of the other bars, with a driver inside.
SceneMaker cylinder_in_truss() {
  SceneMaker scene = truss();
  scene.json["links"].erase("three");
  scene.point("tube", "Y", 0, 0)
      .line("tube", "axis", {0, 0}, {1, 0})
      .point("rod", "Z", 0, 0)
      .line("rod", "axis", {0, 0}, {1, 0})
      .slide("cylinder", "tube.axis", "rod.axis")
      .drive("cylinder", "swell", 0.2, -0.1);
  return scene;
}

/// Bars that cross, one with its foot in a slot of the ground: a dyad RRR relative to the other.
SceneMaker crossed_in_a_slot() {
  SceneMaker scene;
  scene.parameter("reach", {{"value", 1.4}, {"velocity", 0.1}, {"tolerance", 0.02}})
      .bar("ground", {{"A", 0}})
      .line("ground", "floor", {0, -0.2}, {1, 0.05})
      .bar("beam", {{"A", 0}, {"M", 0.4}, {"T", 2}})
      .line("beam", "slot", {0, 0.1}, {1, 0.2})
      .bar("strut", {{"M", 0}, {"K", 0.9}})
      .point("strut", "foot", 0.3, -1.1)
      .bar("link", {{"K", 0}, {"P", "reach"}})
      .slot("P_slot", "beam.slot", "link.P")
      .slot("foot_slot", "ground.floor", "strut.foot")
      .drive("P_slot", 1.1, 0.3, 0.2);
  return scene;
}

Json lift() {
  return scene_json(std::filesystem::path(ASSUR_EXAMPLES) / "scissor_lift_crossed.json");
}

/// The lift with a screw on its table that turns as the lower bars open.
Json lift_with_a_law() {
  Json scene = lift();
  scene["links"]["screw"] = {{"T", {0, 0}}, {"W", {0.2, 0.1}}};
  scene["joints"]["T"] = {{"type", "revolute"}, {"between", {"table.T", "screw.T"}}};
  scene["drivers"]["T"] = {{"position", "2*joint(M) + 0.1*joint(F)"}};
  scene["outputs"]["W"] = "screw.W";
  return scene;
}

int compare(const std::vector<NamedScene>& named) {
  const TemporaryDirectory directory;
  std::vector<EmittedScene> scenes;
  for (const NamedScene& scene : named) {
    const auto file = directory.write(scene.name + ".json", scene.json.dump());
    scenes.push_back({file, scene.name, scene.solver, {}});
  }
  int all = 0;
  for (const int compared : compare_with_solve(scenes)) {
    EXPECT_GT(compared, 0);
    all += compared;
  }
  return all;
}

TEST(EmitRelativeGroups, AgreeWithSolve) {
  const int compared =
      compare({{"truss", "Truss", truss().scene()},
               {"cylinder_in_truss", "CylinderInTruss", cylinder_in_truss().scene()},
               {"crossed", "Crossed", crossed_in_a_slot().scene()},
               {"lift_with_a_law", "LiftWithALaw", lift_with_a_law()}});
  EXPECT_GT(compared, 5000);
}

/// Whether links turn slowly in all configurations that are compared: near singular ones they turn
/// fast, and their rates magnify rounding.
bool is_far_from_singular(const Json& scene) {
  constexpr double fast = 10;
  return std::ranges::all_of(driver_steps, [&](double step) {
    const mechanism::Plan plan(mechanism::parse_scene(stepped(scene, step).dump(), "scene.json"));
    const mechanism::Solution solution = plan.solve(plan.values());
    return std::ranges::all_of(solution.configurations, [](const mechanism::Configuration& one) {
      return std::ranges::all_of(one.links, [](const mechanism::Frame& link) {
        return std::abs(link.velocity(2)) < fast;
      });
    });
  });
}

/// Random scenes with few drivers: where many drivers carry one another, compilers take long.
TEST(EmitRelativeGroups, AgreeWithSolveInRandomScenes) {
  std::vector<NamedScene> scenes;
  const std::size_t wanted = is_whole_campaign() ? 12 : 1;
  for (unsigned seed = 1; scenes.size() < wanted; ++seed) {
    const RandomDrivenScene made(seed, Places::anywhere, 1, Ties::groups);
    const mechanism::Plan plan(mechanism::parse_scene(made.scene().dump(), "scene.json"));
    constexpr std::size_t few = 2;
    if (plan.structure().has_relative_groups() && plan.most_configurations() <= 32 &&
        plan.mechanism().drivers().size() <= few && is_far_from_singular(made.scene())) {
      const std::string number = std::to_string(seed);
      scenes.push_back({"random_" + number, "Random" + number, made.scene()});
    }
  }
  EXPECT_GT(compare(scenes), 500);
}

/// Relative groups within relative groups: lengths are roots of formulas that contain other roots.
/// The rates of roots have names, because second rates written out took four times the text.
TEST(EmitRelativeGroups, NameTheRatesOfRoots) {
  const TemporaryDirectory directory;
  const RandomDrivenScene made(27188, Places::anywhere, 1, Ties::groups);
  const auto file = directory.write("nested.json", made.scene().dump());
  const CommandResult emitted =
      run_assur("emit --scene '" + file.string() + "' --output " + directory.path().string());
  EXPECT_EQ(emitted.status, 0) << emitted.messages;
  constexpr std::uintmax_t most_bytes = 350000;
  EXPECT_LT(std::filesystem::file_size(directory.path() / "assur/scenes/nested.hpp"), most_bytes);
}

/// Where links of a relative group stand is not known without a configuration.
TEST(EmitRelativeGroups, RefuseWhatCannotBeAssembled) {
  const TemporaryDirectory directory;
  Json scene = lift();
  scene["parameters"]["stroke"] = 2;
  const auto file = directory.write("lift.json", scene.dump());
  const CommandResult emitted =
      run_assur("emit --scene '" + file.string() + "' --output " + directory.path().string());
  EXPECT_EQ(emitted.status, 2);
  EXPECT_NE(
      emitted.messages.find("lift.json: links: some are solved relative to a moving link, and "
                            "no configuration at the scene's own numbers shows"),
      std::string::npos)
      << emitted.messages;
}

}  // namespace
}  // namespace assur::test::emit_relative_groups_test
