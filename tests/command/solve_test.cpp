// Law: `assur solve` gives the worked mechanism the values of an independent derivation and of
// differences of solutions, and reports every scene and sweep according to its contract.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "command/command.hpp"
#include "largest.hpp"

namespace assur::test::solve_test {
namespace {

using Json = nlohmann::ordered_json;

const std::string worked = ASSUR_EXAMPLES "/quintero_2011_rrp_rrr.json";

Json solved(const std::string& arguments) {
  const CommandResult result = run_assur("solve " + arguments + " --format json");
  EXPECT_EQ(result.status, 0) << result.messages;
  return Json::parse(result.output);
}

/// The configuration of the worked mechanism that the paper draws.
Json drawn_configuration(const std::string& settings = "") {
  const Json root = solved(worked + settings);
  for (const Json& configuration : root["configurations"]) {
    if (std::abs(configuration["links"]["rod"]["theta"].get<double>() - 0.7325) < 0.02) {
      return configuration;
    }
  }
  return {};
}

TEST(WorkedMechanism, IsTheTetradThatThePaperNames) {
  const Json root = solved(worked);
  EXPECT_EQ(root["status"], "ok");
  EXPECT_EQ(root["mobility"], 0);
  EXPECT_EQ(root["groups"][0]["class"], 4);
  EXPECT_EQ(root["groups"][0]["kind"], "RRP-RRR");
  EXPECT_EQ(root["groups"][0]["model"], 2);
  EXPECT_EQ(root["groups"][0]["links"], Json({"rod", "lever", "slider", "bar"}));
}

// Values of an independent derivation in 30-digit arithmetic (docs/reports/quintero_2011.md).
TEST(WorkedMechanism, AgreesWithAnIndependentDerivation) {
  const Json configuration = drawn_configuration();
  const Json& links = configuration["links"];
  constexpr double degree = 3.14159265358979323846 / 180;
  EXPECT_NEAR(links["rod"]["theta"].get<double>() / degree, 41.9682695356, 1e-10);
  EXPECT_NEAR(links["lever"]["theta"].get<double>() / degree, 92.2903675359, 1e-10);
  EXPECT_NEAR(links["bar"]["theta"].get<double>() / degree, -103.092154299, 1e-9);
  EXPECT_NEAR(configuration["joints"]["S"]["displacement"].get<double>(), 307.739262482, 1e-9);
  EXPECT_NEAR(links["rod"]["velocity"][2].get<double>(), -0.00860783887219, 1e-14);
  EXPECT_NEAR(links["lever"]["velocity"][2].get<double>(), -0.474663754894, 1e-12);
  EXPECT_NEAR(links["bar"]["velocity"][2].get<double>(), -0.110310615115, 1e-12);
  EXPECT_NEAR(configuration["joints"]["S"]["velocity"].get<double>(), 62.6008512896, 1e-10);
  EXPECT_NEAR(links["rod"]["acceleration"][2].get<double>(), 0.266304687858, 1e-12);
  EXPECT_NEAR(links["lever"]["acceleration"][2].get<double>(), 0.448468904885, 1e-12);
  EXPECT_NEAR(links["bar"]["acceleration"][2].get<double>(), 0.161533268309, 1e-12);
  EXPECT_NEAR(configuration["joints"]["S"]["acceleration"].get<double>(), -58.4124671031, 1e-10);
}

TEST(WorkedMechanism, SensitivitiesAreTheDifferencesOfSolutions) {
  const Json root = drawn_configuration();
  const std::vector<std::pair<std::string, double>> parameters = {
      {"AG", 275}, {"AB", 100}, {"BE", 500}, {"EF", 300},
      {"GD", 300}, {"FG", 150}, {"FD", 180}, {"phi", 70 * 3.14159265358979323846 / 180}};
  double worst = 0;
  for (const auto& [name, value] : parameters) {
    const double step = name == "phi" ? 1e-5 : 1e-3;
    const auto at = [&, parameter = name, base = value](double offset) {
      std::array<char, 64> setting{};
      (void)std::snprintf(setting.data(), setting.size(), " --set %s=%.17g", parameter.c_str(),
                          base + offset);
      return drawn_configuration(setting.data())["outputs"];
    };
    const Json above = at(step);
    const Json below = at(-step);
    for (const char* point : {"E", "F", "D"}) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const double difference = (above[point]["position"][axis].get<double>() -
                                   below[point]["position"][axis].get<double>()) /
                                  (2 * step);
        const double derived = root["outputs"][point]["sensitivity"][name][axis].get<double>();
        worst = largest(worst, std::abs(difference - derived) / (1 + std::abs(derived)));
      }
    }
  }
  std::cout << "largest relative disagreement " << worst << '\n';
  EXPECT_LT(worst, 2e-8);
}

TEST(WorkedMechanism, ToleranceSumsFollowFromTheSensitivities) {
  const Json point = drawn_configuration()["outputs"]["E"];
  const std::vector<std::pair<std::string, double>> tolerances = {
      {"AG", 0.1}, {"AB", 0.05}, {"BE", 0.1}, {"EF", 0.1}, {"GD", 0.1}, {"FG", 0.1}, {"FD", 0.1}};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    double sum = 0;
    double squares = 0;
    for (const auto& [name, tolerance] : tolerances) {
      const double part = point["sensitivity"][name][axis].get<double>() * tolerance;
      sum += std::abs(part);
      squares += part * part;
    }
    EXPECT_NEAR(point["worst_case"][axis].get<double>(), sum, 1e-14);
    EXPECT_NEAR(point["rss"][axis].get<double>(), std::sqrt(squares), 1e-14);
  }
}

TEST(Solve, LeavesOutWhatIsNotWanted) {
  Json scene = Json::parse(read_file(worked));
  scene["want"] = {"velocity"};
  const TemporaryDirectory directory;
  const Json root = solved(directory.write("scene.json", scene.dump()).string());
  const Json& point = root["configurations"][0]["outputs"]["E"];
  EXPECT_TRUE(point.contains("velocity"));
  for (const char* absent : {"position", "acceleration", "sensitivity", "worst_case", "rss"}) {
    EXPECT_FALSE(point.contains(absent)) << absent;
  }
}

TEST(Solve, DriverAloneIsAMechanismWithoutGroups) {
  const TemporaryDirectory directory;
  const auto file = directory.write("scene.json", R"({
    "parameters": {"r": 2, "phi": "30*deg"},
    "links": {"ground": {"A": [1, 0]}, "crank": {"A": [0, 0], "P": ["r", 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]}},
    "drivers": {"A": {"position": "phi", "velocity": 3, "acceleration": 5}},
    "outputs": {"P": "crank.P"}})");
  const Json root = solved(file.string());
  EXPECT_EQ(root["groups"].size(), 0U);
  const Json& point = root["configurations"][0]["outputs"]["P"];
  const double c = std::sqrt(3) / 2;
  const double s = 0.5;
  EXPECT_NEAR(point["position"][0].get<double>(), 1 + 2 * c, 1e-15);
  EXPECT_NEAR(point["velocity"][0].get<double>(), -6 * s, 1e-14);
  EXPECT_NEAR(point["velocity"][1].get<double>(), 6 * c, 1e-14);
  EXPECT_NEAR(point["acceleration"][0].get<double>(), -10 * s - 18 * c, 1e-14);
  EXPECT_NEAR(point["acceleration"][1].get<double>(), 10 * c - 18 * s, 1e-14);
  EXPECT_NEAR(point["sensitivity"]["r"][0].get<double>(), c, 1e-15);
  EXPECT_NEAR(point["sensitivity"]["phi"][1].get<double>(), 2 * c, 1e-15);
}

// In both motions of a flat parallelogram angular accelerations cancel: they are shown as 0.
/// Accelerations grow with the square of the velocity: at 1e160 they leave the range of double.
TEST(Solve, RatesBeyondTheRangeOfDoubleAreUnknownAndNotRegular) {
  Json scene = Json::parse(R"({
    "links": {"ground": {"A": [0, 0]}, "crank": {"A": [0, 0], "B": [1, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]}},
    "drivers": {"A": {"position": 1, "velocity": 1e160}}, "outputs": {"B": "crank.B"}})");
  const TemporaryDirectory directory;
  const auto configuration = [&] {
    return solved(directory.write("crank.json", scene.dump()).string())["configurations"][0];
  };
  const Json fast = configuration();
  EXPECT_EQ(fast["regularity"], "near-singular");
  EXPECT_TRUE(fast["outputs"]["B"]["acceleration"][0].is_null());
  EXPECT_EQ(fast["outputs"]["B"]["velocity"][1].get<double>(), 1e160 * std::cos(1.0));
  scene["want"] = {"position", "velocity"};
  EXPECT_EQ(configuration()["regularity"], "regular");
}

TEST(Solve, TextShowsNoRoundingInPlaceOfZero) {
  const TemporaryDirectory directory;
  const auto file = directory.write("scene.json", R"({
    "links": {"ground": {"A": [0, 0], "D": [4, 0]}, "crank": {"A": [0, 0], "B": [2, 0]},
              "coupler": {"B": [0, 0], "C": [4, 0], "P": [2, 1]}, "rocker": {"D": [0, 0], "C": [2, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
               "B": {"type": "revolute", "between": ["crank.B", "coupler.B"]},
               "C": {"type": "revolute", "between": ["coupler.C", "rocker.C"]},
               "D": {"type": "revolute", "between": ["ground.D", "rocker.D"]}},
    "drivers": {"A": {"position": 0, "velocity": 1}}, "outputs": {"P": "coupler.P"}})");
  const CommandResult result = run_assur("solve " + file.string());
  EXPECT_EQ(result.status, 0) << result.messages;
  EXPECT_NE(result.output.find("branch 2 of 2"), std::string::npos) << result.output;
  for (const char* rounding : {"e-15 ", "e-16 ", "e-17 ", "e-15\n", "e-16\n", "e-17\n"}) {
    EXPECT_EQ(result.output.find(rounding), std::string::npos) << result.output;
  }
}

TEST(Solve, OverConstrainedSceneIsNamed) {
  Json scene = Json::parse(read_file(worked));
  scene["links"]["ground"]["T"] = {0, 0};
  scene["joints"]["T"] = {{"type", "revolute"}, {"between", {"ground.T", "bar.E"}}};
  const TemporaryDirectory directory;
  const CommandResult result =
      run_assur("solve " + directory.write("scene.json", scene.dump()).string());
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.messages.find("over-constrained by 2: the joints B, E, S, G, F, D, T constrain "
                                 "the links rod, lever, slider, bar more than their freedoms "
                                 "allow"),
            std::string::npos)
      << result.messages;
}

TEST(Solve, SweepWritesARowAStep) {
  Json scene = Json::parse(read_file(worked));
  scene["sweep"] = {{"parameter", "phi"}, {"from", "69*deg"}, {"to", "71*deg"}, {"count", 5}};
  const TemporaryDirectory directory;
  const CommandResult result =
      run_assur("solve --format csv " + directory.write("scene.json", scene.dump()).string());
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output.rfind("step,configuration,branch,phi,crank.x", 0), 0U);
  EXPECT_GE(std::count(result.output.begin(), result.output.end(), '\n'), 6);
}

/// Cells of the lines of a CSV text.
std::vector<std::vector<std::string>> cells(const std::string& text) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    lines.emplace_back();
    std::istringstream parts(line + ",");
    for (std::string cell; std::getline(parts, cell, ',');) {
      lines.back().push_back(cell);
    }
  }
  return lines;
}

/// A pseudo-terminal that nobody watches; it holds a few thousand characters.
class Terminal {
 public:
  Terminal() : master_(posix_openpt(O_RDWR | O_NOCTTY)) {
    grantpt(master_);
    unlockpt(master_);
    name_ = ptsname(master_);
    slave_ = open(name_.c_str(), O_RDWR | O_NOCTTY);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal() {
    close(slave_);
    close(master_);
  }

  [[nodiscard]] const std::string& name() const { return name_; }
  /// What was written to it so far.
  [[nodiscard]] std::string shown() const {
    fcntl(master_, F_SETFL, O_NONBLOCK);
    std::string text;
    std::array<char, 4096> buffer{};
    for (ssize_t count = 0; (count = read(master_, buffer.data(), buffer.size())) > 0;) {
      text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return text;
  }

 private:
  int master_;
  int slave_ = -1;
  std::string name_;
};

/// What a sweep of the worked mechanism shows on a terminal beside the rows that it prints.
std::string shown_by_sweep(int count) {
  Json scene = Json::parse(read_file(worked));
  scene["sweep"] = {{"parameter", "phi"}, {"from", 0}, {"to", "2*pi"}, {"count", count}};
  scene["want"] = {"position"};
  const TemporaryDirectory directory;
  const std::string arguments =
      "solve --format csv " + directory.write("scene.json", scene.dump()).string();
  const Terminal terminal;
  const CommandResult result = run_assur_with_messages_to(terminal.name(), arguments);
  EXPECT_EQ(result.status, 0);
  std::string shown = terminal.shown();
  // A long sweep that still shows no bar is not compared: it is repeated with more steps.
  constexpr int few_steps = 1000;
  if (count < few_steps || !shown.empty()) {
    EXPECT_EQ(result.output, run_assur(arguments).output);
  }
  return shown;
}

TEST(Solve, SweepThatIsQuickShowsNoBar) { EXPECT_EQ(shown_by_sweep(4), ""); }

TEST(Solve, SweepThatTakesMoreThanASecondShowsItsProgressOnATerminal) {
  std::string shown;
  for (int count = 100'000; shown.empty(); count *= 2) {
    ASSERT_LT(count, 5'000'000) << "no sweep has shown a bar";
    shown = shown_by_sweep(count);
  }
  const std::string last = "\r[" + std::string(40, '#') + "] 100 %\r\x1b[K";
  EXPECT_TRUE(shown.starts_with("\r[")) << shown;
  EXPECT_TRUE(shown.ends_with(last)) << shown;
}

TEST(Solve, SweepNamesBranchesAndEvents) {
  Json scene = Json::parse(read_file(worked));
  scene["sweep"] = {{"parameter", "phi"}, {"from", 0}, {"to", "2*pi"}, {"count", 37}};
  const TemporaryDirectory directory;
  const CommandResult result =
      run_assur("solve --format csv " + directory.write("scene.json", scene.dump()).string());
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.messages, "");  // no progress bar where there is no terminal
  const auto lines = cells(result.output);
  std::vector<std::string> events;
  double last = -1;
  int last_step = 0;
  for (std::size_t index = 1; index < lines.size(); ++index) {
    const auto& line = lines[index];
    ASSERT_EQ(line.size(), lines[0].size());
    EXPECT_GE(std::stod(line[3]), last);
    EXPECT_GE(std::stoi(line[0]), last_step);
    last = std::stod(line[3]);
    last_step = std::stoi(line[0]);
    if (!line.back().empty()) {
      events.push_back(line.back());
      EXPECT_EQ(line[1] + line[2], "");
      EXPECT_NEAR(std::stod(line[6]), last, last < 3 ? 1e-14 : 10);  // the crank's angle
    }
  }
  EXPECT_EQ(events, (std::vector<std::string>{"birth 3 4", "fold 2 4", "birth 5 6", "fold 3 5"}));
}

/// The ternary links are congruent and the bars have the length 2: at p = 0, where B is at that
/// distance from E, the group turns freely. Beyond, the branches go on.
TEST(Solve, SweepThroughADegenerateStep) {
  Json scene;
  scene["parameters"] = {{"p", 0}};
  scene["links"] = {{"ground", {{"A", {0, 0}}, {"E", {3, 0}}}},
                    {"crank", {{"A", {0, 0}}, {"B", {1, 0}}}},
                    {"BCG", {{"B", {0, 0}}, {"C", {1.25, 0}}, {"G", {0.5, 0.75}}}},
                    {"EDF", {{"E", {0, 0}}, {"D", {1.25, 0}}, {"F", {0.5, 0.75}}}},
                    {"CD", {{"C", {0, 0}}, {"D", {2, 0}}}},
                    {"GF", {{"G", {0, 0}}, {"F", {2, 0}}}}};
  const std::vector<std::array<std::string, 3>> joints = {
      {"A", "ground", "crank"}, {"B", "crank", "BCG"}, {"E", "ground", "EDF"}, {"C", "BCG", "CD"},
      {"G", "BCG", "GF"},       {"D", "EDF", "CD"},    {"F", "EDF", "GF"}};
  for (const auto& [name, one, other] : joints) {
    scene["joints"][name] = {{"type", "revolute"},
                             {"between", {one + "." + name, other + "." + name}}};
  }
  scene["drivers"]["A"]["position"] = "p";
  scene["want"] = {"position"};
  for (const int count : {20, 21}) {  // odd: a step at p = 0
    scene["sweep"] = {{"parameter", "p"}, {"from", -1}, {"to", 1}, {"count", count}};
    const TemporaryDirectory directory;
    const CommandResult result =
        run_assur("solve --format csv " + directory.write("scene.json", scene.dump()).string());
    std::string events;
    for (const auto& line : cells(result.output)) {
      events += line.back().empty() ? "" : line[3] + " " + line.back() + "; ";
    }
    std::cout << count << " steps: " << events << result.messages << '\n';
    const bool at_step = count % 2 == 1;
    EXPECT_EQ(result.status, at_step ? 1 : 0);
    EXPECT_EQ(events.find("degenerate") != std::string::npos, at_step);
    EXPECT_EQ(result.messages.find("degenerate at p = 0: ") == 0, at_step);
  }
}

/// A tetrad on the ground, all links in their own odd frames, with prismatic joints at B, C, D and
/// E: model 18, whose slides over-determine the angles.
TEST(Solve, DegenerateGroupIsAVerdict) {
  const TemporaryDirectory directory;
  const auto scene = [&](const std::string& angle) {
    return directory
        .write("scene.json", R"({
      "links": {
        "ground": {"B": {"through": [0, 0], "along": [1, 0]},
                   "E": {"through": [4, 0], "along": [0, 1]}},
        "left": {"B": {"through": [0, 0], "along": [1, 0]}, "C": {"through": [0, 1], "along": [1, 1]},
                 "G": [1, 2]},
        "right": {"E": {"through": [0, 0], "along": [0, 1]}, "D": {"through": [0, 1], "along": [)" +
                                 angle + R"(]}, "F": [1, 2]},
        "slide": {"C": {"through": [0, 0], "along": [1, 1]}, "D": {"through": [0, 1], "along": [1, -1]}},
        "bar": {"G": [0, 0], "F": [3, 0]}},
      "joints": {
        "B": {"type": "prismatic", "between": ["ground.B", "left.B"]},
        "C": {"type": "prismatic", "between": ["left.C", "slide.C"]},
        "G": {"type": "revolute", "between": ["left.G", "bar.G"]},
        "E": {"type": "prismatic", "between": ["ground.E", "right.E"]},
        "D": {"type": "prismatic", "between": ["right.D", "slide.D"]},
        "F": {"type": "revolute", "between": ["right.F", "bar.F"]}}})")
        .string();
  };
  CommandResult result = run_assur("solve --format json " + scene("1, -1"));
  EXPECT_EQ(result.status, 1) << result.messages;
  Json root = Json::parse(result.output);
  EXPECT_EQ(root["status"], "degenerate");
  EXPECT_EQ(root["mobility"], 1);
  EXPECT_EQ(root["groups"][0]["model"], 18);
  EXPECT_NE(root["reason"].get<std::string>().find("B, C, D, E"), std::string::npos)
      << root["reason"];
  result = run_assur("solve --format json " + scene("1, -2"));
  EXPECT_EQ(result.status, 1);
  root = Json::parse(result.output);
  EXPECT_EQ(root["mobility"], 0);
  EXPECT_NE(root["reason"].get<std::string>().find("cannot be assembled"), std::string::npos);
}

}  // namespace
}  // namespace assur::test::solve_test
