// Law: `assur solve --branch N` reports that configuration, or branch, as the whole report does.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tuple>

#include "command/command.hpp"

namespace assur::test::branch_option_test {
namespace {

using Json = nlohmann::ordered_json;

const std::string leg = ASSUR_EXAMPLES "/jansen_leg.json";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  return lines;
}

TEST(BranchOption, PicksOneConfiguration) {
  const Json whole = Json::parse(run_assur("solve --format json " + leg).output);
  const std::vector<std::string> configurations = [] {
    std::vector<std::string> parts;
    const std::string text = run_assur("solve " + leg).output;
    for (std::size_t from = text.find("\nconfiguration "); from != std::string::npos;) {
      const std::size_t next = text.find("\nconfiguration ", from + 1);
      parts.push_back(text.substr(from, next - from));
      from = next;
    }
    return parts;
  }();
  ASSERT_EQ(whole["configurations"].size(), 8U);
  ASSERT_EQ(configurations.size(), 8U);
  for (std::size_t number = 1; number <= 8; ++number) {
    const std::string option = " --branch " + std::to_string(number);
    const Json one = Json::parse(run_assur("solve --format json " + leg + option).output);
    EXPECT_EQ(one["groups"], whole["groups"]);
    EXPECT_EQ(one["configurations"], Json::array({whole["configurations"][number - 1]}));
    const std::string text = run_assur("solve " + leg + option).output;
    EXPECT_EQ(text.substr(text.find("\nconfiguration ")), configurations[number - 1]);
  }
}

TEST(BranchOption, PicksOneRowOfATableWithoutSweep) {
  Json scene = Json::parse(read_file(leg));
  scene.erase("sweep");
  const TemporaryDirectory directory;
  const std::string call =
      "solve --format csv " + directory.write("scene.json", scene.dump()).string();
  const auto whole = lines_of(run_assur(call).output);
  EXPECT_EQ(lines_of(run_assur(call + " --branch 3").output),
            (std::vector<std::string>{whole[0], whole[3]}));
}

/// A branch of a sweep is named by the identity in its column, not by the number at a step.
TEST(BranchOption, PicksTheRowsOfOneBranchOfASweep) {
  const auto whole = lines_of(run_assur("solve --format csv " + leg).output);
  for (const int branch : {1, 3, 12}) {
    std::vector<std::string> expected = {whole[0]};
    std::copy_if(whole.begin() + 1, whole.end(), std::back_inserter(expected),
                 [&](const std::string& line) {
                   std::istringstream cells(line);
                   std::string cell;
                   for (int column = 0; column < 3; ++column) {
                     std::getline(cells, cell, ',');
                   }
                   return cell == std::to_string(branch);
                 });
    EXPECT_GT(expected.size(), 100U);
    EXPECT_EQ(
        lines_of(
            run_assur("solve --format csv " + leg + " --branch " + std::to_string(branch)).output),
        expected);
  }
}

/// The sweep of a parallelogram begins at its change point, where each of the branches that cross
/// has a row: `--nearest` follows one of them.
TEST(BranchOption, NearestFollowsOneOfTheBranchesThatCrossAtTheFirstStep) {
  Json scene = Json::parse(R"({"parameters": {"phi": 0},
      "links": {"ground": {"A": [0, 0], "D": [4, 0]}, "crank": {"A": [0, 0], "B": [2, 0]},
                "coupler": {"B": [0, 0], "C": [4, 0]}, "rocker": {"D": [0, 0], "C": [2, 0]}},
      "joints": {}, "drivers": {"A": {"position": "phi"}}, "reference": {"rocker": 0},
      "sweep": {"parameter": "phi", "from": 0, "to": 1, "count": 4}})");
  for (const auto& [pin, one, other] : {std::tuple{"A", "ground", "crank"},
                                        {"B", "crank", "coupler"},
                                        {"C", "coupler", "rocker"},
                                        {"D", "ground", "rocker"}}) {
    scene["joints"][pin] = {
        {"type", "revolute"},
        {"between", {std::string(one) + "." + pin, std::string(other) + "." + pin}}};
  }
  const TemporaryDirectory directory;
  const std::string call =
      "solve --format csv " + directory.write("scene.json", scene.dump()).string();
  EXPECT_EQ(lines_of(run_assur(call + " --nearest").output),
            lines_of(run_assur(call + " --branch 1").output));
  EXPECT_EQ(lines_of(run_assur(call + " --branch 1").output).size(), 5U);
}

TEST(BranchOption, OutOfRangeIsOneLine) {
  const std::vector<std::pair<std::string, std::string>> calls = {
      {"--format json --branch 9",
       "jansen_leg.json: --branch: there is no configuration 9; the highest number is 8\n"},
      {"--format csv --branch 13",
       "jansen_leg.json: --branch: there is no branch 13; the highest number is 12\n"},
      {"--branch 0", "--branch: "},
      {"--branch two", "--branch"},
      {"--set m=500 --branch 1", "--branch: there is no configuration: group 1 (dyad RRR: k, c)"}};
  for (const auto& [options, message] : calls) {
    const CommandResult result = run_assur("solve " + leg + " " + options);
    EXPECT_EQ(result.status, 2) << options;
    EXPECT_EQ(result.output, "");
    EXPECT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'), 1);
    EXPECT_EQ(result.messages.rfind("error: ", 0), 0U) << result.messages;
    EXPECT_NE(result.messages.find(message), std::string::npos) << result.messages;
  }
  EXPECT_NE(run_assur("solve --help").output.find("--branch N"), std::string::npos);
}

}  // namespace
}  // namespace assur::test::branch_option_test
