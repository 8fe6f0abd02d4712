// Law: a solver with variable parameters is, for every value of these, the solver of the scene that
// has those values; and what cannot be an argument is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <regex>
#include <set>

#include "generator/solver_comparison.hpp"
#include "mechanism/scene_maker.hpp"
#include "whole_campaign.hpp"

namespace assur::test::emit_variable_test {
namespace {

using Json = nlohmann::ordered_json;
using Values = std::map<std::string, double>;

struct VariableScene {
  std::string name;  ///< of the file; the solver's is like it
  std::string solver;
  Json json;
  std::vector<Values> values;  ///< of all variable parameters
  std::string variable = "all";
};

/// With a point off the coupler's line, and a length that is a formula.
VariableScene four_bar() {
  SceneMaker scene;
  scene.parameter("ground", 4)
      .parameter("crank", {{"value", 2}, {"tolerance", 0.01}})
      .parameter("coupler", 3)
      .parameter("rocker", 3.5)
      .parameter("reach", "2*coupler")
      .parameter("bend", "20*deg")
      .bar("ground", {{"A", 0}, {"D", "ground"}})
      .bar("crank", {{"A", 0}, {"B", "crank"}})
      .bar("coupler", {{"B", 0}, {"C", "coupler"}})
      .point("coupler", "P", "reach*cos(bend)", "reach*sin(bend)")
      .bar("rocker", {{"D", 0}, {"C", "rocker"}})
      .drive("A", 0.7, 1.5, 0.5);
  const auto lengths = [](double ground, double crank, double coupler, double rocker, double bend) {
    return Values{{"ground", ground},
                  {"crank", crank},
                  {"coupler", coupler},
                  {"rocker", rocker},
                  {"bend", bend}};
  };
  return {"variable_four_bar",
          "VariableFourBar",
          scene.scene(),
          {lengths(4, 2, 3, 3.5, 0.349), lengths(3, 2, 3, 2, 0), lengths(-4, 2, -3, 3.5, -1),
           lengths(40, 20, 30, 35, 0.1), lengths(4, 1e-3, 3, 3.5, 0.349),
           lengths(9, 2, 3, 3.5, 0.349)}};
}

/// A crank whose pin runs in a slot of the rocker, which is turned and off the rocker's pivot.
VariableScene quick_return() {
  SceneMaker scene;
  scene.parameter("height", 3)
      .parameter("turn", 0.3)
      .parameter("offset", 0.4)
      .parameter("crank", 1)
      .point("ground", "A", 0, 0)
      .point("ground", "O", "height/10", "height")
      .bar("crank", {{"O", 0}, {"B", "crank"}})
      .point("rocker", "A", 0, 0)
      .point("rocker", "T", 5, "offset")
      .drive("O", 0.6, 1, 0.5);
  scene.json["links"]["rocker"]["slot"] = {{"through", {0, "offset"}},
                                           {"along", {"cos(turn)", "sin(turn)"}}};
  scene.slot("S", "rocker.slot", "crank.B");
  const auto values = [](double height, double turn, double offset, double crank) {
    return Values{{"height", height}, {"turn", turn}, {"offset", offset}, {"crank", crank}};
  };
  return {"variable_quick_return",
          "VariableQuickReturn",
          scene.scene(),
          {values(3, 0.3, 0.4, 1), values(3, 0, 0, 1), values(-2, 2.9, -0.3, 1.2),
           values(4, 0.3, 9, 1)}};
}

/// A platform on three legs whose corners are anywhere.
VariableScene platform() {
  SceneMaker scene;
  scene.parameter("size", {{"value", 1}, {"tolerance", 0.1}})
      .parameter("slant", 0.25)
      .parameter("leg", 2.5)
      .parameter("base", 4);
  const std::array<std::array<std::string, 2>, 3> corners{
      {{"0", "0"}, {"2*size", "slant"}, {"size", "1.5*size"}}};
  const std::array<std::array<std::string, 2>, 3> feet{
      {{"0", "0"}, {"base", "0"}, {"base/2", "3+slant"}}};
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    const std::string number = std::to_string(corner);
    scene.point("ground", "G" + number, feet[corner][0], feet[corner][1])
        .point("platform", "P" + number, corners[corner][0], corners[corner][1])
        .bar("leg" + number, {{"G" + number, 0}, {"P" + number, "leg"}});
  }
  return {"variable_platform",
          "VariablePlatform",
          scene.scene(),
          {{{"size", 1}, {"slant", 0.25}, {"leg", 2.5}, {"base", 4}},
           {{"size", 1.25}, {"slant", -0.5}, {"leg", 2}, {"base", 5}},
           {{"size", 0.5}, {"slant", 0.125}, {"leg", 3}, {"base", 4}}}};
}

/// A link on three slides of which two are parallel, at a variable distance.
VariableScene parallel_slides() {
  SceneMaker scene;
  scene.parameter("distance", 1.5).parameter("turn", 1.2).parameter("place", 2);
  scene.point("ground", "P0", 0, 0).point("ground", "P1", 0.5, 2).point("ground", "P2", "place", 1);
  scene.json["links"]["frame"] = {
      {"s0", {{"through", {0, 0}}, {"along", {1, 0}}}},
      {"s1", {{"through", {0, "distance"}}, {"along", {2, 0}}}},
      {"s2", {{"through", {1, 0}}, {"along", {"cos(turn)", "sin(turn)"}}}}};
  for (const std::string number : {"0", "1", "2"}) {
    scene.slot("S" + number, "frame.s" + number, "ground.P" + number);
  }
  return {"variable_parallel_slides",
          "VariableParallelSlides",
          scene.scene(),
          {{{"distance", 1.5}, {"turn", 1.2}, {"place", 2}},
           {{"distance", -1}, {"turn", -0.4}, {"place", 1}},
           {{"distance", 2.5}, {"turn", 1.2}, {"place", 2}}}};
}

/// A link on three slides whose directions vary; they cross as the scene has them.
VariableScene turning_slides() {
  SceneMaker scene;
  scene.parameter("turn", 0.3).parameter("other", 1.2).parameter("distance", 1.5);
  scene.point("ground", "P0", 0, 0).point("ground", "P1", 0.5, 2).point("ground", "P2", 2, 1);
  scene.json["links"]["frame"] = {
      {"s0", {{"through", {0, 0}}, {"along", {1, 0}}}},
      {"s1", {{"through", {0, "distance"}}, {"along", {"cos(turn)", "sin(turn)"}}}},
      {"s2", {{"through", {1, 0}}, {"along", {"cos(other)", "sin(other)"}}}}};
  for (const std::string number : {"0", "1", "2"}) {
    scene.slot("S" + number, "frame.s" + number, "ground.P" + number);
  }
  const auto values = [](double turn, double other) {
    return Values{{"turn", turn}, {"other", other}, {"distance", 1.5}};
  };
  return {"variable_turning_slides",
          "VariableTurningSlides",
          scene.scene(),
          {values(0.3, 1.2), values(0, 1.2), values(1e-8, 1.2), values(3.141592653589793, 1.2),
           values(0.3, 0), values(0.3, 0.3)}};
}

/// Its coupler is drawn far from the origin, its rocker, called like a root, has a tolerance below
/// a root that does not vary.
VariableScene drawn_bars() {
  SceneMaker scene;
  scene.parameter("bx", 500)
      .parameter("by", 800)
      .parameter("cx", 503)
      .parameter("cy", 800.5)
      .parameter("area", {{"value", 10}, {"tolerance", 0.1}})
      .parameter("rise", 1)
      .bar("ground", {{"A", 0}, {"D", 4}})
      .bar("crank", {{"A", 0}, {"B", 2}})
      .point("coupler", "B", "bx", "by")
      .point("coupler", "C", "cx", "cy")
      .point("coupler", "P", "bx+1", "by+(cx-bx)^3/20")
      .point("root_1", "D", 0, 0)
      .point("root_1", "C", "sqrt(area)", "rise")
      .drive("A", 0.7, 1.5, 0.5);
  const auto values = [](double bx, double cy, double rise) {
    return Values{{"bx", bx}, {"by", 800}, {"cx", 503}, {"cy", cy}, {"rise", rise}};
  };
  return {"variable_drawn_bars",
          "VariableDrawnBars",
          scene.scene(),
          {values(500, 800.5, 1), values(500.25, 799.5, -0.5)},
          "bx,by,cx,cy,rise"};
}

Json with_values(Json scene, const Values& values) {
  for (const auto& [name, value] : values) {
    Json& parameter = scene["parameters"][name];
    (parameter.is_object() ? parameter["value"] : parameter) = value;
  }
  return scene;
}

/// Of an example: its independent parameters as they are, and all a little longer.
VariableScene example(const std::filesystem::path& file, const std::string& solver) {
  VariableScene scene{file.stem().string(), solver, scene_json(file), {}};
  const TemporaryDirectory directory;
  emit_solver({file, "", "", {}}, directory, "--variable all");
  const std::string text = read_file(directory.path() / "assur" / "scenes" / (scene.name + ".hpp"));
  const std::regex member(R"(Scalar (\w+)\{ Scalar\(([^)]*)\) \};)");
  Values nominal;
  Values longer;
  double factor = 1;
  for (std::sregex_iterator found(text.begin(), text.end(), member), end; found != end; ++found) {
    const double value = std::stod((*found)[2]);
    nominal[(*found)[1]] = value;
    longer[(*found)[1]] = value * (factor += 0.0078125);
  }
  scene.values = {nominal, longer};
  return scene;
}

std::vector<VariableScene> variable_scenes() {
  std::vector<VariableScene> scenes = {four_bar(), turning_slides()};
  if (is_whole_campaign()) {
    scenes.insert(scenes.end(), {quick_return(), platform(), parallel_slides(), drawn_bars()});
    const std::filesystem::path examples = ASSUR_EXAMPLES;
    for (const auto& [file, solver] :
         std::map<std::string, std::string>{{"jansen_leg", "JansenLeg"},
                                            {"platform_3rpr", "Platform3rpr"},
                                            {"quintero_2011_rrp_rrr", "Quintero2011RrpRrr"},
                                            {"shaper_quick_return", "ShaperQuickReturn"},
                                            {"slider_crank", "SliderCrank"},
                                            {"stephenson_triad", "StephensonTriad"},
                                            {"zhauyt_2017_six_bar", "Zhauyt2017SixBar"}}) {
      scenes.push_back(example(examples / (file + ".json"), solver));
    }
  }
  return scenes;
}

/// Follows both configurations of the four-bar while crank and lengths change at once, in three
/// calls, and beside that from one of many small steps to the nearest configuration of the next;
/// prints by how much the two differ. Then follows a way on which the bars cannot reach.
constexpr const char* following = R"(
namespace following {
using S = assur::scenes::VariableFourBar;
struct Stand {
  S::Drivers<double> drivers;
  S::Parameters<double> parameters;
  explicit Stand(double part) {
    drivers.A.position = 0.7 + 2 * part;
    parameters.crank = 2 - part;
    parameters.coupler = 3 + part;
    parameters.rocker = 3.5 + part / 2;
    parameters.ground = 4 - part / 4;
    parameters.bend = part;
  }
};
void run() {
  std::array<S::State<double>, S::max_configurations> states;
  for (int configuration = 0; configuration < 2; ++configuration) {
    const Stand start(0);
    auto branch = S::branch(start.drivers, start.parameters, configuration);
    S::State<double> tracked{};
    bool ok = true;
    for (const double part : {0.25, 0.75, 1.0}) {
      const Stand stand(part);
      ok = ok && S::track(stand.drivers, stand.parameters, branch, tracked).status ==
                     assur::Status::ok;
    }
    (void)S::solve(start.drivers, start.parameters, states);
    S::State<double> near = states[static_cast<std::size_t>(configuration)];
    for (int step = 1; step <= 1000; ++step) {
      const Stand stand(step / 1000.0);
      const auto found = S::solve(stand.drivers, stand.parameters, states);
      const auto from = near.outputs.P.position;
      const bool second = found.count > 1 && (states[1].outputs.P.position - from).norm() <
                                                 (states[0].outputs.P.position - from).norm();
      near = states[second ? 1 : 0];
    }
    std::printf("%d %.17g\n", ok ? 1 : 0,
                (near.outputs.P.position - tracked.outputs.P.position).norm());
  }
  Stand apart(0);
  auto branch = S::branch(apart.drivers, apart.parameters, 0);
  apart.parameters.ground = 9;
  S::State<double> state{};
  const auto way = S::track(apart.drivers, apart.parameters, branch, state);
  std::printf("%d %.17g\n", way.status == assur::Status::no_convergence ? 1 : 0, way.reached);
  apart.parameters.bend = std::numeric_limits<double>::quiet_NaN();
  const auto lost = S::solve(apart.drivers, apart.parameters, states);
  std::printf("%d\n", lost.status == assur::AssemblyStatus::not_finite ? 1 : 0);
}
}  // namespace following
)";

/// How far the ground's length goes from 4 to 9 before the four-bar of `following` cannot reach.
double reach_of_ground() {
  const double x = 2 * std::cos(0.7);
  const double y = 2 * std::sin(0.7);
  return (x + std::sqrt(6.5 * 6.5 - y * y) - 4) / (9 - 4);
}

void expect_followed(std::istream& printed) {
  int ok = 0;
  double value = 0;
  for (int configuration = 0; configuration < 2; ++configuration) {
    printed >> ok >> value;
    EXPECT_EQ(ok, 1);
    EXPECT_LE(value, 1e-12);
  }
  printed >> ok >> value;
  EXPECT_EQ(ok, 1);
  EXPECT_LE(value, reach_of_ground());
  EXPECT_GE(value, reach_of_ground() - 0.002);
  printed >> ok;
  EXPECT_EQ(ok, 1);
}

/// Each variable parameter is read where something is placed.
void expect_parameters_are_read(const std::filesystem::path& header, const Values& values) {
  const std::string text = read_file(header);
  for (const auto& [name, value] : values) {
    EXPECT_NE(text.find("Scalar " + name + "{"), std::string::npos) << name;
    EXPECT_TRUE(std::regex_search(text, std::regex("\\bp\\." + name + "\\b"))) << name;
  }
}

TEST(EmitVariable, IsTheSolverOfTheSceneWithTheseValues) {
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  std::string includes;
  std::string functions;
  std::string calls;
  std::vector<EmittedScene> scenes;
  std::vector<SolveReadings> expected;
  const std::vector<VariableScene> variable = variable_scenes();
  for (const VariableScene& one : variable) {
    const auto file = directory.write(one.name + ".json", one.json.dump());
    emit_solver({file, one.name, one.solver, {}}, directory, "--variable " + one.variable);
    includes += "#include <assur/scenes/" + one.name + ".hpp>\n";
    expect_parameters_are_read(directory.path() / "assur" / "scenes" / (one.name + ".hpp"),
                               one.values.front());
    for (const Values& values : one.values) {
      const std::string name = one.name + "_" + std::to_string(scenes.size());
      scenes.push_back({directory.write(name + ".json", with_values(one.json, values).dump()),
                        one.name,
                        one.solver,
                        {}});
      expected.push_back(solve_readings(scenes.back()));
      functions += printing_function(scenes.back(), expected.back(), name, values);
      calls += "  " + name + "();\n";
    }
  }
  const auto source =
      directory.write("driver.cpp", includes + program_head + functions + following +
                                        "int main() {\n" + calls + "  following::run();\n}\n");
  const std::string first = includes.substr(0, includes.find('\n') + 1);
  check_by_clang(directory.write("header.cpp", first), directory, true);
  compile(ASSUR_COMPILER, "-O0 -o " + root + "/driver", source, directory);
  ASSERT_FALSE(HasFailure());
  ASSERT_EQ(std::system((root + "/driver > " + root + "/printed").c_str()), 0);
  std::istringstream printed(read_file(directory.path() / "printed"));
  int compared = 0;
  for (std::size_t index = 0; index < scenes.size(); ++index) {
    SCOPED_TRACE(scenes[index].file.stem().string());
    compared += compare_printed(printed, scenes[index], expected[index]);
  }
  expect_followed(printed);
  std::printf("%d numbers of %zu scenes\n", compared, scenes.size());
  EXPECT_GT(compared, 4000);
}

CommandResult emit_with(const std::string& options, const Json& scene) {
  const TemporaryDirectory directory;
  const auto file = directory.write("scene.json", scene.dump());
  const CommandResult result = run_assur("emit --scene " + file.string() + " --output " +
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
      {"Unused", "--variable spare", "nothing that is reported depends on it", unused},
      {"NoTruth", "", "parameters.crank.variable: expected true or false", word},
      {"NoLength", "--variable coupler", "is zero at the scene's own numbers", point},
  };
}

INSTANTIATE_TEST_SUITE_P(Scenes, EmitVariableRefuses, testing::ValuesIn(refused()),
                         [](const auto& entry) { return entry.param.name; });

TEST(EmitVariable, TheTextIsTheSameInEveryProcess) {
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

TEST(EmitVariable, TheKeyDoesTheSameAsTheOption) {
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

}  // namespace
}  // namespace assur::test::emit_variable_test
