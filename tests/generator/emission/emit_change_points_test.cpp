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

/// A slider-crank with crank and rod of one length, whose crank turns by a law of another joint.
Json crank_by_law() {
  SceneMaker maker;
  maker.bar("ground", {{"O", 5}, {"A", 0}}).bar("knob", {{"O", 0}}).point("piston", "C", 0, 0);
  maker.bar("crank", {{"A", 0}, {"B", 1}}).bar("rod", {{"B", 0}, {"C", 1}});
  maker.line("ground", "S", {0, 0}, {1, 0}).line("piston", "S", {0, 0}, {1, 0});
  maker.slide("S", "ground.S", "piston.S").drive("O", 0, 0, 0);
  maker.drive("A", "1.4 + joint(O)^2", 0, 0);
  return positions_of_C(maker, "piston");
}

/// The crank's pin goes round a circle with a parameter, and there are gaps.
Json pin_by_parameter() {
  SceneMaker maker;
  maker.parameter("p", of(0.1)).bar("ground", {{"A", 0}}).bar("rod", {{"B", 0}, {"C", 1}});
  maker.point("crank", "A", 0, 0).point("crank", "B", "1.5*cos(p)", "1.5*sin(p)");
  maker.point("piston", "C", 0, 0);
  maker.line("ground", "S", {0, 0}, {1, 0}).line("piston", "S", {0, 0}, {1, 0});
  maker.slide("S", "ground.S", "piston.S").drive("A", 0, 0, 0);
  return positions_of_C(maker, "piston");
}

/// A slider-crank with crank and rod of one length, whose crank is the rocker of a four-bar.
Json crank_by_rocker() {
  SceneMaker maker;
  maker.bar("ground", {{"A", 0}, {"D", 3.5}}).bar("crank", {{"A", 0}, {"B", 1}});
  maker.bar("coupler", {{"B", 0}, {"E", 3}}).bar("rocker", {{"D", 0}, {"E", 2.5}, {"F", 1}});
  maker.bar("rod", {{"F", 0}, {"C", 1}}).point("piston", "C", 0, 0);
  maker.line("ground", "S", {3.5, 0}, {-0.6, 0.8}).line("piston", "S", {0, 0}, {1, 0});
  maker.slide("S", "ground.S", "piston.S").drive("A", 0.7, 0, 0);
  return positions_of_C(maker, "piston");
}

/// Where inputs begin at rest, turn back or go round within a call: what one call reaches is what
/// many short calls reach.
TEST(EmitChangePoints, OneCallReachesNoMoreThanManyDo) {
  const TemporaryDirectory directory;
  std::string includes;
  for (const auto& [stem, scene] :
       {std::pair("by_law", crank_by_law()), std::pair("by_parameter", pin_by_parameter()),
        std::pair("by_rocker", crank_by_rocker())}) {
    const auto file = directory.write(stem + std::string(".json"), scene.dump());
    emit_solver({file, stem, struct_of(stem), {}}, directory);
    includes += "#include <assur/scenes/" + std::string(stem) + ".hpp>\n";
  }
  const auto source = directory.write("calls.cpp", includes + R"(#include <cstdio>
#include <random>
template <typename Solver>
struct Calls {
  using State = typename Solver::template State<double>;
  static bool follow(double from, double to, int calls, int configuration, State& state) {
    auto branch = begin(from, configuration);
    bool goes_on = true;
    for (int call = 1; call <= calls && goes_on; ++call) {
      goes_on = assur::is_solvable(track(from + (to - from) * call / calls, branch, state));
    }
    return goes_on;
  }
  static auto drivers(double position) {
    typename Solver::template Drivers<double> given;
    *given.positions()[0] = position;
    return given;
  }
  static auto begin(double at, int configuration) {
    return Solver::branch(drivers(at), configuration);
  }
  static assur::Status track(double to, typename Solver::Branch& branch, State& state) {
    return Solver::track(drivers(to), branch, state).status;
  }
};
using Pin = assur::scenes::ByParameter;
template <>
struct Calls<Pin> {
  using State = Pin::State<double>;
  static Pin::Parameters<double> parameters(double p) {
    Pin::Parameters<double> given;
    given.p = p;
    return given;
  }
  static bool follow(double from, double to, int calls, int configuration, State& state) {
    const Pin::Drivers<double> drivers;
    auto branch = Pin::branch(drivers, parameters(from), configuration);
    bool goes_on = true;
    for (int call = 1; call <= calls && goes_on; ++call) {
      goes_on = assur::is_solvable(
          Pin::track(drivers, parameters(from + (to - from) * call / calls), branch, state).status);
    }
    return goes_on;
  }
};
int reached = 0;
int stopped = 0;
int wrong = 0;
template <typename Solver>
void run(double first, double last, int configurations, int ways) {
  std::mt19937_64 random(61);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  for (int way = 0; way < ways; ++way) {
    const double from = way % 3 == 0 ? first : between(first, last);
    const double to = way % 4 == 1 ? first : between(first, last);
    for (int configuration = 0; configuration < configurations; ++configuration) {
      typename Calls<Solver>::State once;
      typename Calls<Solver>::State often;
      if (!Calls<Solver>::follow(from, to, 1, configuration, once)) {
        ++stopped;
        continue;
      }
      ++reached;
      const bool goes_on = Calls<Solver>::follow(from, to, 97, configuration, often);
      const auto apart = once.outputs.C.position - often.outputs.C.position;
      wrong += goes_on && apart.norm() < 1e-9 ? 0 : 1;
    }
  }
}
int main() {
  run<assur::scenes::ByLaw>(0, 0.8, 2, 40);
  run<Pin>(0.1, 0.1 + 6.283185307179586, 2, 40);
  run<assur::scenes::ByRocker>(0.6669463445036643, 1.7, 4, 40);
  std::printf("%d %d %d\n", reached, stopped, wrong);
}
)");
  const std::string program = (directory.path() / "calls").string();
  compile_program(source, program, directory);
  ASSERT_EQ(std::system((program + " > " + program + ".txt").c_str()), 0);
  std::istringstream printed(read_file(program + ".txt"));
  int reached = 0;
  int stopped = 0;
  int wrong = -1;
  printed >> reached >> stopped >> wrong;
  std::printf("%d calls reached their end, %d stopped\n", reached, stopped);
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(reached, 30);
  EXPECT_GT(stopped, 60);
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
