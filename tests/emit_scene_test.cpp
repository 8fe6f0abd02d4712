// Law: the solver emitted for a scene agrees with `assur solve`, and holds nothing unwanted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "command.hpp"

namespace assur::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double agreement = 1e-12;
const std::vector<double> steps = {0, 0.05, -0.11, 0.31};

std::vector<fs::path> examples() {
  std::vector<fs::path> list;
  for (const char* directory : {ASSUR_EXAMPLES, ASSUR_SCENES}) {
    for (const auto& entry : fs::directory_iterator(directory)) {
      if (entry.path().extension() == ".json") {
        list.push_back(entry.path());
      }
    }
  }
  std::sort(list.begin(), list.end());
  return list;
}

std::string struct_of(const fs::path& scene) {
  std::string name;
  bool capital = true;
  for (const char c : scene.stem().string()) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (plain) {
      name += static_cast<char>(capital ? std::toupper(c) : c);
    }
    capital = !plain;
  }
  return name;
}

/// The scene with every driver moved on by a step.
Json stepped(Json scene, double step) {
  if (!scene.contains("drivers")) {
    return scene;
  }
  for (auto& [name, driver] : scene["drivers"].items()) {
    const Json position = driver["position"];
    const std::string text = position.is_string() ? position.get<std::string>() : position.dump();
    std::ostringstream moved;
    moved.precision(17);
    moved << "(" << text << ") + (" << step << ")";
    driver["position"] = moved.str();
  }
  return scene;
}

/// One number of a configuration: of which sort it is, the C++ that reads it, and its value.
struct Reading {
  std::string sort;
  std::string code;
  double value;
};

void read_vector(const std::string& sort, const std::string& code, const Json& values,
                 std::vector<Reading>& readings) {
  for (std::size_t index = 0; index < values.size(); ++index) {
    readings.push_back({sort, code + "(" + std::to_string(index) + ")", values[index]});
  }
}

/// What `assur solve` says of a configuration, with the members that say the same.
std::vector<Reading> readings_of(const Json& configuration, const std::string& solver) {
  std::vector<Reading> readings;
  for (const auto& [name, link] : configuration["links"].items()) {
    const std::string member = "s.links." + name;
    if (name == "ground") {
      continue;
    }
    if (link.contains("theta")) {
      readings.push_back({"length", member + ".pose.x", link["x"]});
      readings.push_back({"length", member + ".pose.y", link["y"]});
      const double theta = link["theta"];
      readings.push_back({"direction", member + ".pose.direction.cos", std::cos(theta)});
      readings.push_back({"direction", member + ".pose.direction.sin", std::sin(theta)});
    }
    for (const char* rate : {"velocity", "acceleration"}) {
      if (link.contains(rate)) {
        const Json& values = link[rate];
        read_vector(rate, member + "." + rate, {values[0], values[1]}, readings);
        readings.push_back(
            {std::string("angular ") + rate, member + "." + rate + "(2)", values[2]});
      }
    }
  }
  for (const auto& [name, slide] : configuration["joints"].items()) {
    for (const auto& [what, value] : slide.items()) {
      const std::string sort = what == "displacement" ? "length" : what;
      readings.push_back({sort, "s.slides." + name + "." + what, value});
    }
  }
  for (const auto& [name, output] : configuration["outputs"].items()) {
    const std::string member = "s.outputs." + name + ".";
    for (const char* what : {"position", "velocity", "acceleration"}) {
      if (output.contains(what)) {
        read_vector(what == std::string("position") ? "length" : what, member + what, output[what],
                    readings);
      }
    }
    if (output.contains("sensitivity")) {
      for (const auto& [parameter, pair] : output["sensitivity"].items()) {
        for (int row = 0; row < 2; ++row) {
          readings.push_back({"sensitivity to " + parameter,
                              "sensitivity<" + solver + ">(s.outputs." + name + ".sensitivity, \"" +
                                  parameter + "\", " + std::to_string(row) + ")",
                              pair[static_cast<std::size_t>(row)]});
        }
      }
    }
  }
  readings.push_back({"regularity", "s.regularity == assur::Status::ok ? 1.0 : 0.0",
                      configuration["regularity"] == "regular" ? 1.0 : 0.0});
  return readings;
}

/// The entry of a parameter; NaN where it is not modelled.
const char* const program_head = R"(#include <cstdio>
#include <cstring>
#include <limits>
template <typename Solver, typename Matrix>
double sensitivity(const Matrix& matrix, const char* parameter, int row) {
  for (int column = 0; column < Solver::parameter_count; ++column) {
    if (std::strcmp(Solver::parameters[static_cast<std::size_t>(column)], parameter) == 0) {
      return matrix(row, column);
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}
)";

/// What `assur solve` finds for one scene, step by step.
struct Expectation {
  std::string solver;
  std::vector<std::vector<std::vector<Reading>>> steps;  ///< [step][configuration]
};

Expectation expectation_of(const fs::path& scene, const TemporaryDirectory& directory) {
  Expectation result{"assur::scenes::" + struct_of(scene), {}};
  for (const double step : steps) {
    const Json moved = stepped(Json::parse(read_file(scene)), step);
    const fs::path file = directory.write("stepped.json", moved.dump());
    const CommandResult solved = run_assur("solve " + file.string() + " --format json");
    EXPECT_EQ(solved.status, 0) << scene << " at " << step << ": " << solved.messages;
    std::vector<std::vector<Reading>>& configurations = result.steps.emplace_back();
    if (solved.status != 0) {
      continue;
    }
    const Json root = Json::parse(solved.output);
    for (const Json& configuration : root["configurations"]) {
      configurations.push_back(readings_of(configuration, result.solver));
    }
  }
  return result;
}

/// Prints, for each step, the number of configurations and then every reading of each.
std::string program_of(const Expectation& expected, const Json& scene, int number) {
  std::string code = "void print_" + std::to_string(number) +
                     "() {\n  using S = " + expected.solver +
                     ";\n  std::array<S::State<double>, S::max_configurations> states;\n";
  const std::vector<Reading>* readings = nullptr;
  for (const auto& configurations : expected.steps) {
    if (!configurations.empty()) {
      readings = &configurations.front();
    }
  }
  const Json drivers = scene.value("drivers", Json::object());
  for (const double step : steps) {
    std::ostringstream text;
    text.precision(17);
    text << "  {\n    S::Drivers<double> drivers;\n";
    for (const auto& [name, driver] : drivers.items()) {
      text << "    drivers." << name << ".position += " << step << ";\n";
    }
    text << "    const S::Solution found = S::solve(drivers, states);\n"
         << "    std::printf(\"%d\\n\", found.count);\n"
         << "    for (int i = 0; i < found.count; ++i) {\n"
         << "      print(states[static_cast<std::size_t>(i)]);\n    }\n  }\n";
    code += text.str();
  }
  std::string print = "void print(const " + expected.solver + "::State<double>& s) {\n";
  if (readings != nullptr) {
    for (const Reading& reading : *readings) {
      print += "  std::printf(\"%.17g\\n\", " + reading.code + ");\n";
    }
  }
  return print + "  (void)s;\n}\n" + code + "}\n";
}

TEST(EmitScene, AgreesWithSolveOverAllExamples) {
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  std::string program;
  std::string calls;
  std::vector<Expectation> expected;
  for (const fs::path& scene : examples()) {
    const CommandResult emitted = run_assur("emit --scene " + scene.string() + " --output " + root);
    ASSERT_EQ(emitted.status, 0) << emitted.messages;
    program += "#include <assur/scenes/" + scene.stem().string() + ".hpp>\n";
  }
  program += program_head;
  for (const fs::path& scene : examples()) {
    expected.push_back(expectation_of(scene, directory));
    const int number = static_cast<int>(expected.size());
    program += program_of(expected.back(), Json::parse(read_file(scene)), number);
    calls += "  print_" + std::to_string(number) + "();\n";
  }
  const fs::path source = directory.write("driver.cpp", program + "int main() {\n" + calls + "}\n");
  const std::string compile = std::string(ASSUR_COMPILER) +
                              " -std=c++17 -O0 -Wall -Wextra -Wconversion -Wshadow -Werror -I" +
                              root + " -I" ASSUR_RUNTIME " -isystem " ASSUR_EIGEN " " +
                              source.string() + " -o " + root + "/driver 2> " + root + "/errors";
  ASSERT_EQ(std::system(compile.c_str()), 0)
      << read_file(directory.path() / "errors").substr(0, 4000);
  ASSERT_EQ(std::system((root + "/driver > " + root + "/states").c_str()), 0);

  std::istringstream states(read_file(directory.path() / "states"));
  double largest = 0;
  int compared = 0;
  for (const Expectation& scene : expected) {
    double largest_here = 0;
    for (std::size_t step = 0; step < scene.steps.size(); ++step) {
      std::size_t count = 0;
      states >> count;
      ASSERT_EQ(count, scene.steps[step].size()) << scene.solver << " at step " << steps[step];
      for (const std::vector<Reading>& configuration : scene.steps[step]) {
        // Errors are relative to the largest number of a sort in the configuration.
        std::map<std::string, double> sizes;
        for (const Reading& reading : configuration) {
          double& size = sizes[reading.sort];
          size = std::max(size, std::abs(reading.value));
        }
        for (const Reading& reading : configuration) {
          std::string text;
          states >> text;
          const double value = std::strtod(text.c_str(), nullptr);
          if (std::isnan(value) && reading.sort.starts_with("sensitivity")) {
            continue;  // the scene has tolerances, and this parameter has none
          }
          const double size = sizes[reading.sort];
          const double error = std::abs(value - reading.value) / (size > 0 ? size : 1);
          EXPECT_LE(error, agreement) << scene.solver << " at step " << steps[step] << ": "
                                      << reading.code << " " << value << " " << reading.value;
          largest_here = std::max(largest_here, error);
          ++compared;
        }
      }
    }
    std::printf("%s: largest relative difference %.1e\n", scene.solver.c_str(), largest_here);
    largest = std::max(largest, largest_here);
  }
  std::printf("all: %.1e over %d numbers\n", largest, compared);
  EXPECT_GT(compared, 100);
}

/// The text of a header without comments.
std::string code_of(const std::string& text) {
  std::istringstream in(text);
  std::string code;
  std::string line;
  while (std::getline(in, line)) {
    code += line.substr(0, line.find("//")) + "\n";
  }
  return code;
}

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

TEST(EmitScene, HoldsWhatIsWantedAlone) {
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

TEST(EmitScene, IsTheSameInEveryProcess) {
  std::string first;
  for (int process = 0; process < 4; ++process) {
    const std::string text = emitted_with(R"(["position", "velocity", "sensitivity"])");
    first = process == 0 ? text : first;
    EXPECT_EQ(text, first);
  }
}

TEST(EmitScene, CheckFindsAChangeAndWritesNothing) {
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
  EXPECT_EQ(result.messages, "differs: " + name + "\n");
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

TEST(EmitScene, RefusesWhatHasNoSolver) {
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
}  // namespace assur::test
