// Law: a solver with variable parameters is, for every value of these, the solver of the scene that
// has those values.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <regex>

#include "generator/solver_comparison.hpp"
#include "generator/variable_scenes.hpp"
#include "whole_campaign.hpp"

namespace assur::test::emit_variable_test {
namespace {

using namespace variable;

/// An example with its independent parameters as they are, and with all of them a little longer.
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
    scenes.insert(scenes.end(),
                  {quick_return(), platform(), meeting_pivots(), parallel_slides(), drawn_bars()});
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

/// Follows both configurations of the four-bar while crank and lengths change together: in three
/// calls of `track`, and in many small steps, each to the nearest configuration; prints by how much
/// the two differ. Then follows a change of length by which the bars cease to reach.
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

/// The part of the ground's way from 4 to 9 after which the four-bar of `following` cannot reach.
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

/// Expects that the solver declares each variable parameter and reads it.
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
  compile_program(source, root + "/driver", directory);
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

}  // namespace
}  // namespace assur::test::emit_variable_test
