// Law: the solver emitted for a scene agrees with `assur solve` where the scene is in special
// position: the same verdict, families and configurations in the same order.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numbers>
#include <set>

#include "generator/solver_comparison.hpp"
#include "mechanism/scene_maker.hpp"
#include "whole_campaign.hpp"

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

/// Two equal bars from one pin of the ground: their final polynomial vanishes for all inputs.
SceneMaker bars_on_one_pin() {
  SceneMaker scene;
  scene.point("ground", "A", 1, 2)
      .point("ground", "D", 1, 2)
      .bar("one", {{"A", 0}, {"C", 2}})
      .bar("other", {{"D", 0}, {"C", 2}});
  return scene;
}

/// Two sliders that a pin joins, on parallel guides.
SceneMaker parallel_guides() {
  SceneMaker scene;
  scene.line("ground", "low", {0, 0}, {1, 0})
      .line("ground", "high", {0, 2}, {1, 0})
      .line("one", "shoe", {0, 0}, {1, 0})
      .point("one", "C", 0, 1)
      .line("other", "shoe", {0, 0}, {1, 0})
      .point("other", "C", 0, -1)
      .slide("S", "ground.low", "one.shoe")
      .slide("T", "ground.high", "other.shoe");
  return scene;
}

/// A crank and a group of six links, all in one line.
Json row_of_six_links() {
  return Json::parse(R"({
    "points": {"A": [-2, 0], "B": [3, 0], "C": [0, 0], "D": [-1, 0], "E": [-2, 0], "F": [-3, 0],
               "G": [-1, 0], "H": [-1, 0], "I": [3, 0], "J": [-2, 0]},
    "links": {"ground": ["H", "A"], "crank": ["B", "A"], "one": ["C", "H", "I"], "two": ["E", "G"],
              "three": ["C", "D"], "four": ["D", "F", "J"], "five": ["G", "I", "J"],
              "six": ["E", "F", "B"]},
    "drivers": {"A": {"position": "pi", "velocity": 1}}})");
}

/// The same with two links between the same two pins, so that the group moves.
Json row_that_moves() {
  return Json::parse(R"({
    "points": {"A": [0, 0], "B": [1, 0], "C": [1, 0], "D": [-2, 0], "E": [2, 0], "F": [-3, 0],
               "G": [-3, 0], "H": [0, 0], "I": [1, 0], "J": [-2, 0]},
    "links": {"ground": ["E", "F", "A"], "crank": ["B", "A"], "one": ["G", "I", "J"],
              "two": ["C", "D"], "three": ["B", "G"], "four": ["D", "E", "J"], "five": ["F", "H"],
              "six": ["C", "H", "I"]},
    "drivers": {"A": {"position": "pi", "velocity": 1}}})");
}

/// Five configurations of six links, of which one is double.
Json double_of_six_links() {
  return Json::parse(R"({
    "points": {"A": [0, -1], "B": [3, 2], "C": [0, 3], "D": [-1, -1], "E": [-1, -2], "F": [2, 1],
               "G": [2, -1], "H": [-3, -3], "I": [-2, 0], "J": [3, 2]},
    "links": {"ground": ["F", "J", "A"], "one": ["C", "D"], "two": ["C", "F", "G"],
              "three": ["E", "B"], "four": ["D", "E", "H", "I"], "five": ["I", "J"],
              "crank": ["B", "A"], "six": ["G", "H"]},
    "drivers": {"A": {"position": "-3/4*pi", "velocity": 1}}})");
}

/// A crank with two dyads, and a third dyad between the first one and the ground. In one of the
/// first's two configurations the third's outer pins coincide, and there it moves if its bars are
/// equal.
SceneMaker dyads_before_a_kite(double bar, double reach) {
  SceneMaker scene;
  scene.bar("ground", {{"A", 0}, {"D", 5}, {"E", -2}})
      .point("ground", "Q", 3, 3)
      .bar("crank", {{"A", 0}, {"S", 1}, {"B", 2}})
      .bar("a1", {{"B", 0}})
      .point("a1", "C", 0, 3)
      .point("a1", "P", 1, 3)
      .bar("b1", {{"D", 0}})
      .point("b1", "C", -3, 3)
      .bar("a2", {{"S", 0}})
      .point("a2", "F", 0, reach)
      .bar("b2", {{"E", 0}})
      .point("b2", "F", 3, 2)
      .bar("a3", {{"P", 0}, {"R", 4}})
      .bar("b3", {{"Q", 0}, {"R", bar}})
      .drive("A", 0, 1, 0.5);
  scene.json["want"] = {"position"};
  return scene;
}

/// The links and joints of the three dyads in one of the six orders of these.
Json in_order(const Json& scene, const std::array<std::size_t, 3>& order) {
  static const std::array<std::string, 3> joints = {"BCD", "SFE", "PQR"};
  Json result = scene;
  result["links"] = {{"ground", scene["links"]["ground"]}, {"crank", scene["links"]["crank"]}};
  result["joints"] = {{"A", scene["joints"]["A"]}};
  for (const std::size_t dyad : order) {
    for (const std::string side : {"a", "b"}) {
      const std::string link = side + std::to_string(dyad + 1);
      result["links"][link] = scene["links"][link];
    }
    for (const char letter : joints[dyad]) {
      const std::string joint(1, letter);
      result["joints"][joint] = scene["joints"][joint];
    }
  }
  return result;
}

/// Every order of the dyads, with the sides of the joints as they are and exchanged; by default
/// a sixth of these.
void add_every_order(const std::string& name, const Json& scene,
                     std::vector<SpecialScene>& scenes) {
  const bool all = is_whole_campaign();
  std::array<std::size_t, 3> order = {0, 1, 2};
  int number = 0;
  do {
    for (const bool exchanged : {false, true}) {
      if (all || number % 6 == 0) {
        Json listed = in_order(scene, order);
        for (const auto& [joint, entry] : listed["joints"].items()) {
          if (exchanged && joint != "A") {
            std::reverse(entry["between"].begin(), entry["between"].end());
          }
        }
        scenes.push_back({name + "_" + std::to_string(number), listed, {0, 0.5}});
      }
      ++number;
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

std::vector<SpecialScene> special_scenes() {
  const std::vector<double> round = {0, pi, pi / 2, -0.5};
  std::vector<SpecialScene> scenes = {
      {"parallelogram", four_bar(2, 3, 2, 3).scene(), round},
      {"kite", four_bar(2, 3, 3, 2).scene(), round},
      {"slot_through_pivot", slot_through_pivot().scene(), round},
      {"parallel_slots", parallel_slots().scene()},
      {"half_platform", platform(0.5, 2).scene()},
      {"bars_on_one_pin", bars_on_one_pin().scene()},
      {"row_of_six_links", row_of_six_links()},
      {"row_that_moves", row_that_moves()},
      {"double_of_six_links", double_of_six_links()},
  };
  if (is_whole_campaign()) {  // similar to those above
    scenes.insert(
        scenes.end(),
        {
            {"rhombus", four_bar(2, 2, 2, 2).scene(), round},
            {"isosceles_slider_crank", isosceles_slider_crank().scene(), round},
            {"equal_platform", platform(1, 2).scene()},
            {"parallel_guides", parallel_guides().scene()},
            {"parallelogram_back_to_front", scene_listed(four_bar(2, 3, 2, 3).scene(), 1), round},
            {"kite_of_equal_arms", four_bar(4, 4, 2, 2).scene(), round},
            {"half_platform_rotated", scene_listed(platform(0.5, 2).scene(), 2)},
        });
  }
  // First a family for one choice of the first dyad, whatever the second does; then no family,
  // because the kite does not move; last none reported, as the second dyad cannot be assembled.
  add_every_order("kite_behind", dyads_before_a_kite(4, 2).scene(), scenes);
  add_every_order("no_kite_behind", dyads_before_a_kite(3, 2).scene(), scenes);
  scenes.push_back(
      {"kite_beside_what_cannot_reach", dyads_before_a_kite(4, 0.1).scene(), {0, 0.5}});
  return scenes;
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

/// The configuration without the rates that are not known.
Json with_known_numbers(Json configuration) {
  for (const std::string part : {"links", "joints", "outputs"}) {
    for (const auto& [name, entry] : configuration[part].items()) {
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

/// The C++ that reads every number that solve knows in some configuration; it is run for all.
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

/// Expects that the emitted solver gives every number that solve knows; returns how many.
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

TEST(EmitSpecialScenes, AreWarnedOfInOneLine) {
  for (const SceneMaker& scene : {bars_on_one_pin(), parallel_guides()}) {
    const TemporaryDirectory directory;
    const auto file = directory.write("scene.json", scene.scene().dump());
    const CommandResult emitted =
        run_assur("emit --scene '" + file.string() + "' --output " + directory.path().string());
    EXPECT_EQ(emitted.status, 0) << emitted.messages;
    EXPECT_EQ(std::count(emitted.messages.begin(), emitted.messages.end(), '\n'), 1);
    EXPECT_NE(emitted.messages.find("the solution at the scene's own numbers has a family: "),
              std::string::npos)
        << emitted.messages;
  }
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
  compile_program(source, root + "/driver", directory);
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
  EXPECT_EQ(verdicts.size(), 4U);
  EXPECT_GT(compared, 500);
}

}  // namespace
}  // namespace assur::test::emit_special_scenes_test
