// Law: parameters become arguments of an emitted solver by the option or by the scene's key alike,
// in the same bytes everywhere; what cannot be an argument is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "generator/solver_comparison.hpp"
#include "generator/variable_scenes.hpp"

namespace assur::test::emit_variable_options_test {
namespace {

using namespace variable;

CommandResult emit_with(const std::string& options, const Json& scene) {
  const TemporaryDirectory directory;
  const auto file = directory.write("scene.json", scene.dump());
  CommandResult result = run_assur("emit --scene " + file.string() + " --output " +
                                   (directory.path() / "out").string() + " " + options);
  EXPECT_FALSE(result.status != 0 && std::filesystem::exists(directory.path() / "out"));
  return result;
}

struct Refused {
  std::string name, options, message;
  Json scene;
};

class EmitVariableRefuses : public testing::TestWithParam<Refused> {};

TEST_P(EmitVariableRefuses, InOneLine) {
  const CommandResult result = emit_with(GetParam().options, GetParam().scene);
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'), 1);
  EXPECT_NE(result.messages.find(GetParam().message), std::string::npos) << result.messages;
}

/// A tetrad with C at B, from where two parameters move it, and with F at E.
Json coinciding() {
  SceneMaker scene;
  scene.parameter("s", 0).parameter("t", 0);
  scene.point("ground", "B", 0, 0).point("ground", "E", 5, 1);
  scene.point("bcg", "B", 0, 0).point("bcg", "C", "s", "t").point("bcg", "G", 3, -1);
  scene.point("edf", "E", 0, 0).point("edf", "D", -1, 2).point("edf", "F", 0, 0);
  scene.bar("cd", {{"C", 0}, {"D", 3}}).bar("gf", {{"G", 0}, {"F", 3.5}});
  return scene.scene();
}

std::vector<Refused> refused() {
  Json law = four_bar().json;
  law["parameters"]["phi"] = 0.7;
  law["drivers"]["A"]["position"] = "phi";
  Json unused = four_bar().json;
  unused["parameters"]["spare"] = 1;
  Json word = four_bar().json;
  word["parameters"]["crank"] = {{"value", 2}, {"variable", "yes"}};
  Json point = with_values(four_bar().json, {{"coupler", 0}});
  return {
      {"UnknownName", "--variable crnk", "--variable", four_bar().json},
      {"Law", "--variable phi", "only the law of a driver depends on it", law},
      {"Unused", "--variable spare", "no reported result depends on it", unused},
      {"NoTruth", "", "parameters.crank.variable: expected true or false", word},
      {"NoLength", "--variable coupler", "is zero at the scene's own numbers", point},
      {"NoAxis", "--want position,sensitivity", "links.bcg: two of its joints coincide",
       coinciding()},
  };
}

INSTANTIATE_TEST_SUITE_P(Scenes, EmitVariableRefuses, testing::ValuesIn(refused()),
                         [](const auto& entry) { return entry.param.name; });

TEST(EmitVariableOptions, TheTextIsTheSameInEveryProcess) {
  const TemporaryDirectory directory;
  const VariableScene scene = drawn_bars();
  const auto file = directory.write(scene.name + ".json", scene.json.dump());
  std::set<std::string> texts;
  for (int process = 0; process < 16; ++process) {
    emit_solver({file, "", "", {}}, directory, "--variable " + scene.variable);
    texts.insert(read_file(directory.path() / "assur" / "scenes" / (scene.name + ".hpp")));
  }
  EXPECT_EQ(texts.size(), 1U);
  EXPECT_NE(texts.begin()->find("std::pow"), std::string::npos);
  EXPECT_NE(texts.begin()->find("--variable " + scene.variable), std::string::npos);
}

TEST(EmitVariableOptions, TheKeyDoesTheSameAsTheOption) {
  const TemporaryDirectory directory;
  Json scene = four_bar().json;
  const auto emitted = [&](const std::string& options) {
    const auto file = directory.write("scene.json", scene.dump());
    EXPECT_EQ(run_assur("emit --scene " + file.string() + " --output " + directory.path().string() +
                        " " + options)
                  .status,
              0);
    return read_file(directory.path() / "assur" / "scenes" / "scene.hpp");
  };
  const std::string by_option = emitted("--variable crank,rocker");
  scene["parameters"]["rocker"] = {{"value", 3.5}, {"variable", true}};
  scene["parameters"]["crank"]["variable"] = true;
  scene["parameters"]["coupler"] = {{"value", 3}, {"variable", false}};
  EXPECT_EQ(emitted(""), by_option);
  EXPECT_EQ(emitted("--variable rocker"), by_option);
}

/// A frame through two pivots that parameters may bring together may have no direction; so a link's
/// frame goes through two others, if these are fixed in the link.
TEST(EmitVariableOptions, AFrameStandsOnPivotsThatCannotMeet) {
  const TemporaryDirectory directory;
  const VariableScene scene = meeting_pivots();
  const auto file = directory.write(scene.name + ".json", scene.json.dump());
  emit_solver({file, "", "", {}}, directory, "--variable all");
  const std::string text = read_file(directory.path() / "assur" / "scenes" / (scene.name + ".hpp"));
  EXPECT_NE(text.find("p.a"), std::string::npos);
  EXPECT_EQ(text.find("std::sqrt(p."), std::string::npos);
}

}  // namespace
}  // namespace assur::test::emit_variable_options_test
