// Law: an emitted solver contains exactly the results that its scene requests, with the same bytes
// in every process; a scene that cannot have a solver is refused in one line.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "command/command.hpp"
#include "generator/emitted_code.hpp"
#include "generator/solver_comparison.hpp"

namespace assur::test::emit_scene_content_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string emitted_with(const std::string& want) {
  const TemporaryDirectory directory;
  Json scene = Json::parse(read_file(fs::path(ASSUR_EXAMPLES) / "quintero_2011_rrp_rrr.json"));
  scene["want"] = Json::parse(want);
  const fs::path file = directory.write("worked.json", scene.dump());
  const CommandResult result =
      run_assur("emit --scene " + file.string() + " --output " + directory.path().string());
  EXPECT_EQ(result.status, 0) << result.messages;
  const fs::path header = directory.path() / "assur/scenes/worked.hpp";
  std::istringstream lines(read_file(header));
  std::string line;
  while (std::getline(lines, line)) {
    EXPECT_LE(line.size(), 100U) << line;
  }
  return code_of(read_file(header));
}

TEST(EmitSceneContent, HoldsWhatIsWantedAlone) {
  const std::vector<std::string> of_rates = {"velocity", "velocities", "u_rate", "omega_"};
  const std::vector<std::string> of_second_rates = {"acceleration", "motion", "alpha_"};
  const std::vector<std::string> of_sensitivity = {"parameter_jacobian",
                                                   "input_jacobian",
                                                   "pose_jacobians",
                                                   "tolerances",
                                                   "sensitivity",
                                                   "worst_case",
                                                   "rss"};
  const auto expect = [](const std::string& text, const std::vector<std::string>& words,
                         bool present) {
    for (const std::string& word : words) {
      EXPECT_EQ(text.find(word) != std::string::npos, present) << word;
    }
  };
  const std::string everything =
      emitted_with(R"(["position", "velocity", "acceleration", "sensitivity"])");
  expect(everything, of_rates, true);
  expect(everything, of_second_rates, true);
  expect(everything, of_sensitivity, true);
  const std::string position = emitted_with(R"(["position"])");
  expect(position, of_rates, false);
  expect(position, of_second_rates, false);
  expect(position, of_sensitivity, false);
  const std::string velocity = emitted_with(R"(["position", "velocity"])");
  expect(velocity, of_rates, true);
  expect(velocity, of_second_rates, false);
  expect(velocity, of_sensitivity, false);
  const std::string sensitivity = emitted_with(R"(["position", "sensitivity"])");
  expect(sensitivity, of_rates, false);
  expect(sensitivity, of_second_rates, false);
  expect(sensitivity, of_sensitivity, true);
  // Parameters without a tolerance are not modelled where others have one.
  EXPECT_EQ(everything.find("\"phi\""), std::string::npos);
  EXPECT_NE(everything.find("\"AB\""), std::string::npos);
}

/// Compilers warn of a point that is computed and not used.
TEST(EmitSceneContent, PlacesNoPointOfWhichNothingIsWanted) {
  const TemporaryDirectory directory;
  const fs::path file = directory.write("crank.json", R"({"links": {"ground": {"A": [0, 0]},
      "crank": {"A": [0, 0], "P": [1, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]}},
    "drivers": {"A": {"position": 1.5}}, "outputs": {"P": "crank.P"}})");
  const auto emitted = [&](const std::string& want) {
    const CommandResult result = run_assur("emit --scene " + file.string() + " --want " + want +
                                           " --output " + directory.path().string());
    EXPECT_EQ(result.status, 0) << result.messages;
    return code_of(read_file(directory.path() / "assur/scenes/crank.hpp"));
  };
  EXPECT_NE(emitted("position").find("point_P"), std::string::npos);
  EXPECT_EQ(emitted("sensitivity").find("point_P"), std::string::npos);
}

/// Rates that a law gives as numbers are no arguments, whatever their sign and their place.
TEST(EmitSceneContent, TellsOfRatesThatAreNoArguments) {
  const TemporaryDirectory directory;
  Json scene = Json::parse(R"({"links": {"ground": {"A": [0, 0], "D": [4, 0]},
      "crank": {"A": [0, 0], "P": [1, 0]}, "wheel": {"D": [0, 0], "Q": [1, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
               "D": {"type": "revolute", "between": ["ground.D", "wheel.D"]}},
    "outputs": {"P": "crank.P", "Q": "wheel.Q"}})");
  const auto has_own_rates = [&](const Json& wheel) {
    scene["drivers"] = {{"A", {{"position", 0.5}, {"velocity", 1}}}, {"D", wheel}};
    const fs::path file = directory.write("gears.json", scene.dump());
    const CommandResult result =
        run_assur("emit --scene " + file.string() + " --output " + directory.path().string());
    EXPECT_EQ(result.status, 0) << result.messages;
    const std::string code = code_of(read_file(directory.path() / "assur/scenes/gears.hpp"));
    return code.find("has_own_rates = true") != std::string::npos;
  };
  const std::string law = "-2*joint(A)";
  EXPECT_FALSE(has_own_rates({{"position", law}}));
  EXPECT_TRUE(has_own_rates({{"position", law}, {"velocity", 3}}));
  EXPECT_TRUE(has_own_rates({{"position", law}, {"velocity", -3}}));
  EXPECT_TRUE(has_own_rates({{"position", law}, {"acceleration", -3}}));
}

/// The lines under "How to call it" in the head of a solver.
std::string usage_in(const std::string& header) {
  const std::string lead = "//   ";
  std::istringstream lines(header.substr(header.find("// How to call it:\n")));
  std::string line;
  std::getline(lines, line);
  std::string usage;
  while (std::getline(lines, line) && line.starts_with(lead)) {
    usage += line.substr(lead.size()) + "\n";
  }
  return usage;
}

TEST(EmitSceneContent, ShowsInItsHeadHowToCallIt) {
  const TemporaryDirectory directory;
  const CommandResult result =
      run_assur("emit --scene " ASSUR_EXAMPLES "/slider_crank.json --variable all --output " +
                directory.path().string());
  ASSERT_EQ(result.status, 0) << result.messages;
  const std::string usage = usage_in(read_file(directory.path() / "assur/scenes/slider_crank.hpp"));
  EXPECT_LE(std::count(usage.begin(), usage.end(), '\n'), 11);  // ten, and the parameters
  const std::size_t end = usage.find('\n') + 1;
  const fs::path source = directory.write(
      "use.cpp",
      usage.substr(0, end) + "int main() {\n" + usage.substr(end) +
          "return found.count == 2 && states[0].regularity == assur::Status::ok ? 0 : 1;\n}\n");
  const std::string program = (directory.path() / "use").string();
  compile_program(source, program, directory);
  EXPECT_EQ(std::system(program.c_str()), 0) << usage;
}

TEST(EmitSceneContent, ShowsInTheHeadOfItsCInterfaceHowToCallIt) {
  const TemporaryDirectory directory;
  const CommandResult result = run_assur(
      "emit --scene " ASSUR_EXAMPLES "/slider_crank.json --variable all --interface c --output " +
      directory.path().string());
  ASSERT_EQ(result.status, 0) << result.messages;
  const std::string usage = usage_in(read_file(directory.path() / "assur/scenes/slider_crank.h"));
  EXPECT_LE(std::count(usage.begin(), usage.end(), '\n'), 11);  // ten, and the parameters
  const std::size_t end = usage.find('\n') + 1;
  const fs::path source = directory.write(
      "use.c", usage.substr(0, end) + "int main(void) {\n" + usage.substr(end) +
                   "return found.count == 2 && status == slider_crank_status_ok ? 0 : 1;\n}\n");
  const std::string compile = ASSUR_COMPILER
                              " -x c -std=c99 -Wall -Wextra -Werror -pedantic -c -I" +
                              directory.path().string() + " " + source.string() + " -o " +
                              (directory.path() / "use.o").string();
  EXPECT_EQ(std::system(compile.c_str()), 0) << usage;
}

TEST(EmitSceneContent, IsTheSameInEveryProcess) {
  std::string first;
  for (int process = 0; process < 4; ++process) {
    const std::string text = emitted_with(R"(["position", "velocity", "sensitivity"])");
    first = process == 0 ? text : first;
    EXPECT_EQ(text, first);
  }
}

TEST(EmitSceneContent, CheckFindsAChangeAndWritesNothing) {
  const TemporaryDirectory directory;
  const std::string arguments = "emit --scene " ASSUR_EXAMPLES
                                "/quintero_2011_rrp_rrr.json --output " +
                                directory.path().string();
  const std::string name = "assur/scenes/quintero_2011_rrp_rrr.hpp";
  EXPECT_EQ(run_assur(arguments + " --check").status, 1);
  EXPECT_FALSE(fs::exists(directory.path() / name));
  ASSERT_EQ(run_assur(arguments).status, 0);
  EXPECT_EQ(run_assur(arguments + " --check").status, 0);
  directory.write(name, "// changed\n");
  const CommandResult result = run_assur(arguments + " --check");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.messages, name + " differs from what would be written\n");
  EXPECT_EQ(read_file(directory.path() / name), "// changed\n");
}

/// One line of message, exit status 2 and nothing written.
void expect_refusal(const std::string& scene, const std::string& words) {
  const TemporaryDirectory directory;
  const fs::path file = directory.write("scene.json", scene);
  const fs::path output = directory.path() / "out";
  const CommandResult result =
      run_assur("emit --scene " + file.string() + " --output " + output.string());
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.messages.find(words), std::string::npos) << result.messages;
  EXPECT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'), 1);
  EXPECT_FALSE(fs::exists(output));
}

TEST(EmitSceneContent, RefusesWhatHasNoSolver) {
  Json scene = Json::parse(read_file(fs::path(ASSUR_EXAMPLES) / "quintero_2011_rrp_rrr.json"));
  Json freed = scene;
  freed["drivers"] = Json::object();
  expect_refusal(freed.dump(), "under-constrained");
  Json held = scene;
  held["joints"]["X"] = {{"type", "revolute"}, {"between", {"ground.A", "bar.F"}}};
  expect_refusal(held.dump(), "over-constrained");
  Json groundless = scene;
  groundless["joints"]["A"]["between"] = {"grund.A", "crank.A"};
  expect_refusal(groundless.dump(), "no link named");
  // A dyad of slides alone: its angles are over-determined.
  expect_refusal(R"({"links": {
    "ground": {"a": {"through": [0, 0], "along": [1, 0]}, "b": {"through": [1, 0], "along": [0, 1]}},
    "one": {"a": {"through": [0, 0], "along": [1, 0]}, "c": {"through": [0, 0], "along": [1, 1]}},
    "two": {"b": {"through": [0, 0], "along": [0, 1]}, "c": {"through": [0, 0], "along": [1, 1]}}},
    "joints": {"A": {"type": "prismatic", "between": ["ground.a", "one.a"]},
               "B": {"type": "prismatic", "between": ["ground.b", "two.b"]},
               "C": {"type": "prismatic", "between": ["one.c", "two.c"]}}})",
                 "degenerate");
}

}  // namespace
}  // namespace assur::test::emit_scene_content_test
