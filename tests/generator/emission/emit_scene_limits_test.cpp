// Law: an emitted solver leaves out the same configurations beyond joint limits as `assur solve`,
// counts them, and follows branches through the limits and back.
#include <gtest/gtest.h>

#include <numbers>
#include <sstream>

#include "generator/solver_comparison.hpp"
#include "whole_campaign.hpp"

namespace assur::test::emit_scene_limits_test {
namespace {

using Json = nlohmann::ordered_json;

constexpr double pi = std::numbers::pi;

/// An example with limits on some of its joints.
struct LimitedExample {
  std::string stem, solver;
  std::map<std::string, std::array<double, 2>> limits;
  /// The two links, in their order, of pins that a drawing does not name as joints.
  std::map<std::string, std::array<std::string, 2>> pins = {};
};

Json limited_scene(const LimitedExample& example) {
  Json scene = scene_json(std::filesystem::path(ASSUR_EXAMPLES) / (example.stem + ".json"));
  for (const auto& [joint, links] : example.pins) {
    scene["joints"][joint] = {{"type", "revolute"}, {"links", links}};
  }
  for (const auto& [joint, limits] : example.limits) {
    scene["joints"][joint]["limits"] = limits;
  }
  return scene;
}

/// Pins on the ground, pins between moving links, slides, pins in slots, a gear that others move
/// and cylinders with drivers, each with limits that leave some configurations out; by default
/// every other one.
const std::vector<LimitedExample> examples = {
    {"gripper", "Gripper", {{"E", {-pi, -1.2}}, {"D", {4 * pi, 1 + 4 * pi}}}},
    {"slider_crank", "SliderCrank", {{"S", {0, 1000}}}},
    {"shaper_quick_return",
     "ShaperQuickReturn",
     {{"B", {0, 1000}}, {"C", {0, pi}}},
     {{"C", {"rocker", "link"}}}},
    {"excavator_arm",
     "ExcavatorArm",
     {{"boom_cylinder", {2.4, 2.8}}, {"B", {0, 1.8}}},
     {{"B", {"stick", "bucket"}}}},
    {"geared_five_bar", "GearedFiveBar", {{"C", {0, pi}}}},
};

TEST(EmitSceneLimits, LeaveOutWhatSolveLeavesOut) {
  const TemporaryDirectory directory;
  std::vector<EmittedScene> scenes;
  for (const LimitedExample& example : share_of(examples, 2)) {
    const Json scene = limited_scene(example);
    const auto file = directory.write(example.stem + ".json", scene.dump());
    scenes.push_back({file, example.stem, example.solver, {}});
    const Json all = Json::parse(run_assur("solve " + file.string() + " --format json").output);
    EXPECT_GT(all["left_out"].get<int>(), 0) << example.stem;
    EXPECT_GT(all["configurations"].size(), 0U) << example.stem;
  }
  for (const int compared : compare_with_solve(scenes)) {
    EXPECT_GT(compared, 0);
  }
}

TEST(EmitSceneLimits, AreCountedAndFollowedThroughAndMayBeArguments) {
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  Json scene = limited_scene({"slider_crank", "", {}});
  scene["parameters"]["nearest"] = {{"value", 150}, {"variable", true}};
  scene["joints"]["S"]["limits"] = {"nearest", 1000};
  const auto file = directory.write("slider.json", scene.dump());
  emit_solver({file, "slider", "Slider", {}}, directory);
  const auto source = directory.write("driver.cpp", R"(#include <assur/scenes/slider.hpp>
#include <cstdio>
int main() {
  using S = assur::scenes::Slider;
  std::array<S::State<double>, S::max_configurations> states;
  S::Drivers<double> drivers;
  S::Parameters<double> parameters;
  auto branch = S::branch(drivers, parameters, 0);
  for (int step = 0; step < 32; ++step) {
    drivers.A.position = 0.7 + 0.2 * step;
    const S::Solution found = S::solve(drivers, parameters, states);
    S::State<double> state;
    const S::Track way = S::track(drivers, parameters, branch, state);
    const int status = static_cast<int>(way.status);
    const int none = static_cast<int>(S::branch(drivers, parameters, found.count).status);
    std::printf("%d %d %d %d %d %.17g\n", found.count, found.left_out, status, none,
                way.within_limits ? 1 : 0, state.slides.S.displacement);
  }
  parameters.nearest = -1000;
  std::printf("%d\n", S::solve(drivers, parameters, states).count);
}
)");
  compile_program(source, root + "/driver", directory);
  ASSERT_EQ(std::system((root + "/driver > " + root + "/printed").c_str()), 0);
  std::istringstream printed(read_file(directory.path() / "printed"));
  std::array<int, 2> rows{};
  for (int step = 0; step < 32; ++step) {
    std::ostringstream angle;
    angle.precision(17);
    angle << 0.7 + 0.2 * step;
    const Json solved = Json::parse(
        run_assur("solve " + file.string() + " --format json --set phi=" + angle.str()).output);
    int count = 0;
    int left_out = 0;
    int status = 0;
    int none = 0;
    int within = 0;
    double displacement = 0;
    printed >> count >> left_out >> status >> none >> within >> displacement;
    EXPECT_EQ(count, static_cast<int>(solved["configurations"].size()));
    EXPECT_EQ(left_out, solved["left_out"].get<int>());
    EXPECT_EQ(count + left_out, 2);
    EXPECT_EQ(status, 0);
    EXPECT_NE(none, 0);
    EXPECT_EQ(within, displacement >= 150 ? 1 : 0) << displacement;
    ++rows[static_cast<std::size_t>(within)];
  }
  EXPECT_GT(rows[0], 5);
  EXPECT_GT(rows[1], 5);
  int all = 0;
  printed >> all;
  EXPECT_EQ(all, 2);
}

TEST(EmitSceneLimits, LeaveNoTextWhereThereAreNone) {
  const TemporaryDirectory directory;
  emit_solver({std::filesystem::path(ASSUR_EXAMPLES) / "gripper.json", "gripper", "Gripper", {}},
              directory);
  const std::string code = read_file(directory.path() / "assur/scenes/gripper.hpp");
  for (const char* word : {"limit", "Limit"}) {
    EXPECT_EQ(code.find(word), std::string::npos) << word;
  }
}

}  // namespace
}  // namespace assur::test::emit_scene_limits_test
