// Law: the solver emitted for a scene agrees with `assur solve` where the scene is in special
// position: the same verdict, families and configurations in the same order.
#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "generator/solver_comparison.hpp"
#include "mechanism/scene_maker.hpp"

namespace assur::test::emit_special_scenes_test {
namespace {

using Json = nlohmann::ordered_json;

/// A scene, and how far its drivers are moved on from where it has them.
struct SpecialScene {
  std::string name;
  Json json;
  std::vector<double> steps = {0};
};

constexpr double pi = std::numbers::pi;

SceneMaker four_bar(double crank, double coupler, double rocker, double ground) {
  SceneMaker scene;
  scene.bar("ground", {{"A", 0}, {"D", ground}})
      .bar("crank", {{"A", 0}, {"B", crank}})
      .bar("coupler", {{"B", 0}, {"C", coupler}})
      .bar("rocker", {{"D", 0}, {"C", rocker}})
      .drive("A", 0, 1, 0.5);
  return scene;
}

/// A rod as long as the crank: the slider may stand still at A.
SceneMaker isosceles_slider_crank() {
  SceneMaker scene;
  scene.point("ground", "A", 0, 0)
      .line("ground", "guide", {0, 0}, {1, 0})
      .bar("crank", {{"A", 0}, {"B", 2}})
      .bar("rod", {{"B", 0}, {"C", 2}})
      .point("slider", "C", 0, 0)
      .line("slider", "shoe", {0, 0}, {1, 0})
      .slide("S", "ground.guide", "slider.shoe")
      .drive("A", 0, 1, 0.5);
  return scene;
}

/// A rocker that turns about A with a slot for the pin B of the crank: the pin passes A.
SceneMaker slot_through_pivot() {
  SceneMaker scene;
  scene.point("ground", "A", 0, 0)
      .point("ground", "O", 2, 0)
      .bar("crank", {{"O", 0}, {"B", -2}})
      .point("rocker", "A", 0, 0)
      .line("rocker", "slot", {0, 0}, {1, 0})
      .slot("S", "rocker.slot", "crank.B")
      .drive("O", 0, 1, 0.5);
  return scene;
}

/// A platform with three pins in slots, two of which are parallel.
SceneMaker parallel_slots() {
  SceneMaker scene;
  scene.line("ground", "s0", {0, 0}, {1, 0})
      .line("ground", "s1", {0, 2}, {1, 0})
      .line("ground", "s2", {1, 0}, {0, 1})
      .point("platform", "P0", 0, 0)
      .point("platform", "P1", 1, 2)
      .point("platform", "P2", 2, 1);
  for (const std::string number : {"0", "1", "2"}) {
    scene.slot("S" + number, "ground.s" + number, "platform.P" + number);
  }
  return scene;
}

/// A platform on three equal legs.
SceneMaker platform(double size, double leg) {
  const std::array<std::array<double, 2>, 3> corners{{{0, 0}, {4, 0}, {2, 3}}};
  SceneMaker scene;
  for (std::size_t corner = 0; corner < corners.size(); ++corner) {
    const std::string number = std::to_string(corner);
    const auto [x, y] = corners[corner];
    scene.point("ground", "G" + number, x, y)
        .point("platform", "P" + number, size * x, size * y)
        .bar("leg" + number, {{"G" + number, 0}, {"P" + number, leg}});
  }
  return scene;
}

std::vector<SpecialScene> special_scenes() {
  const std::vector<double> round = {0, pi, pi / 2, -0.5};
  std::vector<SpecialScene> scenes = {
      {"parallelogram", four_bar(2, 3, 2, 3).scene(), round},
      {"parallelogram_back_to_front", scene_listed(four_bar(2, 3, 2, 3).scene(), 1), round},
      {"rhombus", four_bar(2, 2, 2, 2).scene(), round},
      {"kite", four_bar(2, 3, 3, 2).scene(), round},
      {"kite_of_equal_arms", four_bar(4, 4, 2, 2).scene(), round},
      {"isosceles_slider_crank", isosceles_slider_crank().scene(), round},
      {"slot_through_pivot", slot_through_pivot().scene(), round},
      {"parallel_slots", parallel_slots().scene()},
      {"equal_platform", platform(1, 2).scene()},
      {"half_platform", platform(0.5, 2).scene()},
      {"half_platform_rotated", scene_listed(platform(0.5, 2).scene(), 2)},
  };
  return scenes;
}

/// `half_platform` as `HalfPlatform`.
std::string struct_of(const std::string& stem) {
  std::string name;
  for (std::size_t place = 0; place < stem.size(); ++place) {
    const bool first = place == 0 || stem[place - 1] == '_';
    if (stem[place] != '_') {
      name += static_cast<char>(first ? std::toupper(stem[place]) : stem[place]);
    }
  }
  return name;
}

/// What `assur solve` says, and how the emitted solver says the same.
struct Verdict {
  std::string status;
  std::size_t configurations, families;
  int mobility;
};
constexpr const char* verdict_code =
    R"(  std::printf("%s %d %d %d\n", found.status == assur::AssemblyStatus::degenerate
      ? "degenerate" : found.count == 0 ? "no-assembly" : "ok",
      found.count, found.families, found.mobility);
)";

Json solved(const Json& scene, double step) {
  const TemporaryDirectory directory;
  const auto file = directory.write("stepped.json", stepped(scene, step).dump());
  const CommandResult result = run_assur("solve " + file.string() + " --format json");
  EXPECT_LE(result.status, 1) << result.messages;
  return Json::parse(result.output);
}

Verdict verdict_of(const Json& report) {
  Verdict verdict{report["status"], report["configurations"].size(), 0, 0};
  for (const Json& family : report.value("families", Json::array())) {
    ++verdict.families;
    verdict.mobility = std::max(verdict.mobility, int(family["mobility"]));
  }
  return verdict;
}

/// Without the rates that are not known.
Json with_known_numbers(Json configuration) {
  for (const std::string part : {"links", "joints", "outputs"}) {
    for (auto& [name, entry] : configuration[part].items()) {
      Json known = Json::object();
      for (const auto& [what, value] : entry.items()) {
        if (value.dump().find("null") == std::string::npos) {
          known[what] = value;
        }
      }
      entry = known;
    }
  }
  return configuration;
}

/// The number is read from each configuration of the emitted solver, whether or not solve knows it.
std::vector<std::string> codes_of(const std::vector<Json>& reports, const EmittedScene& scene) {
  std::set<std::string> codes;
  for (const Json& report : reports) {
    for (const Json& configuration : report["configurations"]) {
      for (const Reading& reading : ReadingList(scene).read(with_known_numbers(configuration))) {
        codes.insert(reading.code);
      }
    }
  }
  return {codes.begin(), codes.end()};
}

std::string printing_function(const SpecialScene& special, const EmittedScene& scene,
                              const std::vector<std::string>& codes) {
  std::ostringstream code;
  code.precision(17);
  code << "void " << special.name << "(const std::vector<double>& steps) {\n"
       << "  using S = assur::scenes::" << scene.solver
       << ";\n  std::array<S::State<double>, S::max_configurations> states;\n"
       << "  for (const double step : steps) {\n  S::Drivers<double> drivers;\n  (void)step;\n";
  const Json drivers = special.json.value("drivers", Json::object());
  for (const auto& [joint, driver] : drivers.items()) {
    code << "  drivers." << joint << ".position += step;\n";
  }
  code << "  const S::Solution found = S::solve(drivers, states);\n"
       << verdict_code << "  for (int i = 0; i < found.count; ++i) {\n"
       << "    const auto& s = states[static_cast<std::size_t>(i)];\n    (void)s;\n";
  for (const std::string& one : codes) {
    code << "    std::printf(\"%.17g\\n\", " << one << ");\n";
  }
  code << "  }\n  }\n}\n";
  return code.str();
}

/// Expects every number that solve knows to be the emitted solver's; gives how many.
int compare(const Json& configuration, const EmittedScene& scene,
            const std::map<std::string, double>& printed) {
  // Where the Jacobian is singular, positions are known to the root of rounding.
  const bool regular = configuration["regularity"] == "regular";
  const double tolerance = regular ? agreement : 1e-7;
  const auto readings = ReadingList(scene).read(with_known_numbers(configuration));
  std::map<std::string, double> sizes;
  for (const Reading& reading : readings) {
    double& size = sizes[reading.sort];
    size = std::max({size, std::abs(reading.value), 1.0});
  }
  int compared = 0;
  for (const Reading& reading : readings) {
    const bool is_position = reading.sort == "length" || reading.sort == "direction";
    if (regular || is_position || reading.sort == "regularity") {
      EXPECT_NEAR(printed.at(reading.code), reading.value, tolerance * sizes[reading.sort])
          << reading.code;
      ++compared;
    }
  }
  return compared;
}

TEST(EmitSpecialScenes, AgreeWithSolve) {
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  std::string includes = "#include <cstdio>\n#include <vector>\n";
  std::string functions;
  std::ostringstream calls;
  calls.precision(17);
  const std::vector<SpecialScene> specials = special_scenes();
  std::vector<EmittedScene> scenes;
  std::vector<std::vector<Json>> reports;
  std::vector<std::vector<std::string>> codes;
  for (const SpecialScene& special : specials) {
    const auto file = directory.write(special.name + ".json", special.json.dump());
    scenes.push_back({file, special.name, struct_of(special.name), {}});
    emit_solver(scenes.back(), directory);
    auto& of_scene = reports.emplace_back();
    calls << "  " << special.name << "({";
    for (const double step : special.steps) {
      of_scene.push_back(solved(special.json, step));
      calls << step << ", ";
    }
    calls << "});\n";
    codes.push_back(codes_of(of_scene, scenes.back()));
    includes += "#include <assur/scenes/" + special.name + ".hpp>\n";
    functions += printing_function(special, scenes.back(), codes.back());
  }
  const auto source =
      directory.write("driver.cpp", includes + functions + "int main() {\n" + calls.str() + "}\n");
  compile(ASSUR_COMPILER, "-O0 -o " + root + "/driver", source, directory);
  ASSERT_EQ(std::system((root + "/driver > " + root + "/printed").c_str()), 0);
  std::istringstream printed(read_file(directory.path() / "printed"));
  int compared = 0;
  std::map<std::string, int> verdicts;
  for (std::size_t index = 0; index < specials.size(); ++index) {
    for (std::size_t step = 0; step < specials[index].steps.size(); ++step) {
      SCOPED_TRACE(specials[index].name + " at " + std::to_string(specials[index].steps[step]));
      const Verdict expected = verdict_of(reports[index][step]);
      Verdict found;
      printed >> found.status >> found.configurations >> found.families >> found.mobility;
      EXPECT_EQ(found.status, expected.status);
      EXPECT_EQ(found.families, expected.families);
      EXPECT_EQ(found.mobility, expected.mobility);
      ASSERT_EQ(found.configurations, expected.configurations);
      ++verdicts[found.status + (found.families > 0 ? " with families" : "")];
      for (const Json& configuration : reports[index][step]["configurations"]) {
        std::map<std::string, double> numbers;
        for (const std::string& code : codes[index]) {
          std::string text;
          printed >> text;
          numbers[code] = std::strtod(text.c_str(), nullptr);
        }
        compared += compare(configuration, scenes[index], numbers);
      }
    }
  }
  for (const auto& [verdict, count] : verdicts) {
    std::printf("%s: %d\n", verdict.c_str(), count);
  }
  std::printf("%d numbers\n", compared);
  EXPECT_EQ(verdicts.size(), 3U);
  EXPECT_GT(compared, 500);
}

}  // namespace
}  // namespace assur::test::emit_special_scenes_test
