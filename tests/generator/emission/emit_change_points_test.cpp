// Law: `track` of an emitted solver never reports that it reached an end to which its branch does
// not lead through regular configurations.
#include <gtest/gtest.h>

#include "generator/solver_comparison.hpp"
#include "mechanism/scene_maker.hpp"
#include "whole_campaign.hpp"

namespace assur::test::emit_change_points_test {
namespace {

using Json = nlohmann::ordered_json;

Json of(double value) { return {{"value", value}, {"variable", true}}; }

Json positions_of_C(const SceneMaker& maker, const char* link) {
  Json scene = maker.scene();
  scene["outputs"] = {{"C", link + std::string(".C")}};
  scene["want"] = {"position"};
  return scene;
}

Json four_bar() {
  SceneMaker maker;
  maker.parameter("a", of(2)).parameter("b", of(4)).parameter("c", of(3)).parameter("d", of(5));
  maker.bar("ground", {{"A", 0}, {"D", "d"}}).bar("crank", {{"A", 0}, {"B", "a"}});
  maker.bar("coupler", {{"B", 0}, {"C", "b"}}).bar("rocker", {{"D", 0}, {"C", "c"}});
  return positions_of_C(maker.drive("A", 0.7, 0, 0), "rocker");
}

Json slider_crank() {
  SceneMaker maker;
  maker.parameter("r", of(1)).parameter("l", of(2)).parameter("e", of(0));
  maker.bar("ground", {{"A", 0}}).bar("crank", {{"A", 0}, {"B", "r"}});
  maker.bar("rod", {{"B", 0}, {"C", "l"}}).point("piston", "C", 0, 0);
  maker.line("ground", "S", {0, 0}, {1, 0}).line("piston", "S", {0, 0}, {1, 0});
  maker.slide("S", "ground.S", "piston.S").drive("A", 0.7, 0, 0);
  Json scene = positions_of_C(maker, "piston");
  scene["links"]["ground"]["S"]["through"] = {0, "e"};
  return scene;
}

TEST(EmitChangePoints, TracksStopOrStayOnTheirBranch) {
  constexpr unsigned seed = 61;
  const int mechanisms = is_whole_campaign() ? 10000 : 300;
  const TemporaryDirectory directory;
  const auto four = directory.write("four_bar.json", four_bar().dump());
  const auto slider = directory.write("slider_crank.json", slider_crank().dump());
  emit_solver({four, "four_bar", "FourBar", {}}, directory);
  emit_solver({slider, "slider_crank", "SliderCrank", {}}, directory);
  const auto source = directory.write(
      "tracks.cpp",
      "#include <assur/scenes/four_bar.hpp>\n#include <assur/scenes/slider_crank.hpp>\n"
      "#include \"" ASSUR_TESTS
      "/generator/tracked_lengths.hpp\"\n"
      "template <typename Scalar> void run() {\n  assur::test::TrackedLengths tracked(" +
          std::to_string(seed) + ");\n  tracked.follow<Scalar>(" + std::to_string(mechanisms) +
          ");\n  tracked.print();\n}\nint main() {\n  run<double>();\n  run<float>();\n}\n");
  const std::string program = (directory.path() / "tracks").string();
  compile_program(source, program, directory);
  ASSERT_EQ(std::system((program + " > " + program + ".txt").c_str()), 0);
  std::istringstream printed(read_file(program + ".txt"));
  for (const char* const scalar : {"double", "float"}) {
    int reached = 0;
    int stopped = 0;
    int stopped_early = 0;
    int wrong = -1;
    printed >> reached >> stopped >> stopped_early >> wrong;
    std::printf("%s, seed %u: %d tracks reached their end, %d stopped, %d of them early\n", scalar,
                seed, reached, stopped, stopped_early);
    EXPECT_EQ(wrong, 0) << scalar;
    EXPECT_EQ(stopped_early, 0) << scalar;
    EXPECT_GT(reached, mechanisms);
    EXPECT_GT(stopped, mechanisms);
  }
}

}  // namespace
}  // namespace assur::test::emit_change_points_test
