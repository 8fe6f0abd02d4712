// Law: if there are no configurations, the answer names the group that fails to close, the gap, and
// the configurations of the groups that hold it; a sweep reports each such stretch once, with its
// ends.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "command/command.hpp"

namespace assur::test::no_assembly_test {
namespace {

using Json = nlohmann::ordered_json;

Json pin(const std::string& one, const std::string& other) {
  return {{"type", "revolute"}, {"between", Json::array({one, other})}};
}

Json four_bar(double coupler) {
  Json scene;
  scene["parameters"]["phi"] = 1;
  scene["links"]["ground"] = {{"A", {0, 0}}, {"D", {4, 0}}};
  scene["links"]["crank"] = {{"A", {0, 0}}, {"B", {1, 0}}};
  scene["links"]["coupler"] = {{"B", {0, 0}}, {"C", {coupler, 0}}, {"E", {1, 1}}};
  scene["links"]["rocker"] = {{"D", {0, 0}}, {"C", {3, 0}}};
  scene["joints"] = {{"A", pin("ground.A", "crank.A")},
                     {"B", pin("crank.B", "coupler.B")},
                     {"C", pin("coupler.C", "rocker.C")},
                     {"D", pin("ground.D", "rocker.D")}};
  scene["drivers"]["A"]["position"] = "phi";
  return scene;
}

CommandResult solved(const Json& scene, const std::string& format) {
  const TemporaryDirectory directory;
  return run_assur("solve --format " + format + " " +
                   directory.write("scene.json", scene.dump()).string());
}

/// The number that follows some words in a text.
double number_after(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  return at == std::string::npos ? std::nan("") : std::stod(text.substr(at + words.size()));
}

/// A pin in a slot that passes the rocker's pivot at a distance is modelled as two joints of one
/// name.
TEST(NoAssembly, NamesAPinInASlotOnce) {
  Json scene = four_bar(3);
  scene["links"].erase("coupler");
  scene["links"]["rocker"] = {{"D", {0, 0}}, {"slot", {{"through", {0, 9}}, {"along", {1, 0}}}}};
  scene["joints"].erase("C");
  scene["joints"]["B"] = {{"type", "pin-in-slot"}, {"between", {"crank.B", "rocker.slot"}}};
  const Json answer = Json::parse(solved(scene, "json").output);
  EXPECT_EQ(answer["status"], "no-assembly");
  const std::string reason = answer["reason"];
  EXPECT_NE(reason.find("the joints B, D fail to close by"), std::string::npos) << reason;
}

/// The four-bar closes, but a dyad on its coupler is too short in both configurations.
TEST(NoAssembly, NamesTheGroupTheGapAndTheConfigurationsBeforeIt) {
  Json scene = four_bar(3);
  scene["outputs"]["E"] = "coupler.E";
  const Json whole = Json::parse(solved(scene, "json").output);
  ASSERT_EQ(whole["configurations"].size(), 2U);
  double gap = INFINITY;
  double angle = 0;
  for (const Json& configuration : whole["configurations"]) {
    const Json& at = configuration["outputs"]["E"]["position"];
    const double away = std::hypot(at[0].get<double>() - 9, at[1].get<double>() + 2) - 1.75;
    if (away < gap) {
      gap = away;
      angle = configuration["links"]["coupler"]["theta"].get<double>() * 180 / std::acos(-1);
    }
  }
  ASSERT_GT(gap, 0.1);
  scene["links"]["ground"]["H"] = {9, -2};
  scene["links"]["left"] = {{"E", {0, 0}}, {"F", {1, 0}}};
  scene["links"]["right"] = {{"H", {0, 0}}, {"F", {0.75, 0}}};
  scene["joints"]["E"] = pin("coupler.E", "left.E");
  scene["joints"]["F"] = pin("left.F", "right.F");
  scene["joints"]["H"] = pin("ground.H", "right.H");
  const Json answer = Json::parse(solved(scene, "json").output);
  EXPECT_EQ(answer["status"], "no-assembly");
  const std::string reason = answer["reason"];
  EXPECT_EQ(reason.find("group 2 (dyad RRR: left, right): the joints E, F, H fail to close by "),
            0U)
      << reason;
  EXPECT_NE(reason.find(" at least, in 2 of 2 configurations of group 1 (the gap is least with "
                        "coupler at "),
            std::string::npos)
      << reason;
  EXPECT_NEAR(number_after(reason, "fail to close by "), gap, 0.005 * gap);
  EXPECT_NEAR(number_after(reason, "with coupler at "), angle, 0.005 * std::abs(angle));
}

/// |BD|^2 = 17 - 8 cos phi; coupler and rocker reach 4, which is too little where cos phi < 1/8.
TEST(NoAssembly, IsToldOnceAStretchOfASweep) {
  Json scene = four_bar(1);
  scene["sweep"] = {{"parameter", "phi"}, {"from", 0}, {"to", "2*pi"}, {"count", 61}};
  const CommandResult result = solved(scene, "csv");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.messages,
            "no-assembly from phi = 1.46608 to 4.81711 (33 steps): at 3.14159, group 1 (dyad RRR: "
            "coupler, rocker): the joints B, C, D fail to close by 1 at least\n");
}

/// Beside the four-bar, two equal bars on one pivot turn freely wherever the crank stands.
TEST(Degenerate, IsToldOnceAStretchOfASweep) {
  Json scene = four_bar(3);
  scene["links"]["one"] = {{"A", {0, 0}}, {"S", {1, 0}}};
  scene["links"]["other"] = {{"A", {0, 0}}, {"S", {1, 0}}};
  scene["joints"]["one"] = pin("ground.D", "one.A");
  scene["joints"]["S"] = pin("one.S", "other.S");
  scene["joints"]["other"] = pin("ground.D", "other.A");
  scene["sweep"] = {{"parameter", "phi"}, {"from", 0}, {"to", 1}, {"count", 11}};
  const CommandResult result = solved(scene, "csv");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'), 1) << result.messages;
  EXPECT_EQ(
      result.messages.find("degenerate from phi = 0 to 1 (11 steps): the closure of the joints "),
      0U)
      << result.messages;
}

/// A press whose lever turns all the way around. Where the crank lies along the line of the pivots,
/// the rack is too far away for the links that it drives.
Json press() {
  Json scene = Json::parse(read_file(std::filesystem::path(ASSUR_EXAMPLES) / "rack_press.json"));
  scene["parameters"]["crank"] = 100;
  scene["parameters"]["rod"] = 90;
  scene["parameters"]["lever"] = 110;
  scene["parameters"]["pinion"] = 60;
  scene["links"]["ground"]["D"] = {40, 0};
  scene["parameters"]["phi"] = 0;
  return scene;
}

TEST(NoAssembly, TellsHowFarALawHasMovedWhatHoldsTheGroup) {
  const CommandResult result = solved(press(), "json");
  EXPECT_NE(result.output.find("in 2 of 2 configurations of group 1 (the gap is least with rack "
                               "moved by -36.8)"),
            std::string::npos)
      << result.output.substr(0, 600);
}

/// The names of a message do not depend on how the scene is listed.
TEST(NoAssembly, NamesJointsInOneOrder) {
  Json scene = four_bar(9);
  const Json joints = scene["joints"];
  Json backwards = Json::object();
  for (const std::string name : {"D", "C", "B", "A"}) {
    backwards[name] = joints[name];
    std::swap(backwards[name]["between"][0], backwards[name]["between"][1]);
  }
  const auto names_of = [](const Json& of) {
    const std::string reason = Json::parse(solved(of, "json").output)["reason"];
    return reason.substr(0, reason.find("fail to close"));
  };
  const std::string names = names_of(scene);
  scene["joints"] = backwards;
  EXPECT_EQ(names_of(scene), names);
}

TEST(Limits, AreToldOnceAStretchOfASweep) {
  Json scene = four_bar(3);
  scene["joints"]["A"]["limits"] = {0.45, 3};
  scene["sweep"] = {{"parameter", "phi"}, {"from", 0}, {"to", 1}, {"count", 11}};
  const CommandResult result = solved(scene, "csv");
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.messages,
            "beyond the limits of joints from phi = 0 to 0.4 (5 steps): A by 2.86 deg at least\n");
}

int rows_of(const CommandResult& result) {
  return static_cast<int>(std::count(result.output.begin(), result.output.end(), '\n')) - 1;
}

/// On one of the two branches joint D is within its limits throughout, and on the other nowhere.
/// Only the first has a number, as a sweep numbers what `solve` lists.
TEST(Limits, LeaveBranchesThatAreBeyondThemThroughoutWithoutNumbers) {
  Json scene = four_bar(3);
  scene["joints"]["D"]["limits"] = {0, std::numbers::pi};
  scene["sweep"] = {{"parameter", "phi"}, {"from", 0.5}, {"to", 1}, {"count", 11}};
  const CommandResult first = solved(scene, "csv --branch 1");
  EXPECT_EQ(first.status, 0);
  EXPECT_EQ(first.messages, "");
  EXPECT_EQ(rows_of(first), 11);
  const CommandResult second = solved(scene, "csv --branch 2");
  EXPECT_EQ(second.status, 2);
  EXPECT_NE(second.messages.find("there is no branch 2; the highest number is 1\n"),
            std::string::npos)
      << second.messages;
}

}  // namespace
}  // namespace assur::test::no_assembly_test
