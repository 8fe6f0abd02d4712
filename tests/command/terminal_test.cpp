// Law: tables and help fit a terminal of 80 columns, output to a file contains no escape sequence,
// and with --quiet the command prints no message but errors.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "command/command.hpp"

namespace assur::test::terminal_test {
namespace {

const std::string four_bar = ASSUR_EXAMPLES "/four_bar_coupler_curve.json";

/// Lines of tables are indented; a scene's name and sentences may be longer.
void expect_narrow_tables(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_EQ(line.find('\x1b'), std::string::npos) << line;
    if (line.starts_with(" ")) {
      EXPECT_LE(line.size(), 80U) << line;
    }
  }
}

TEST(Tables, FitATerminal) {
  expect_narrow_tables(run_assur("catalogue").output);
  for (const auto& scene : std::filesystem::directory_iterator(ASSUR_EXAMPLES)) {
    if (scene.path().extension() == ".json") {
      SCOPED_TRACE(scene.path().string());
      const CommandResult solved = run_assur("solve " + scene.path().string());
      EXPECT_EQ(solved.status, 0);
      expect_narrow_tables(solved.output);
    }
  }
}

TEST(Tables, KeepTheirColumnsWithAnyName) {
  const std::string path = testing::TempDir() + "/names.json";
  std::ofstream(path) << R"({"links": {"ground": {"A": [0, 0]}, "ä": {"A": [0, 0], "B": [1, 0]},
    "the_longest_of_all_links": {"B": [0, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "ä.A"]},
               "B": {"type": "revolute", "between": ["ä.B", "the_longest_of_all_links.B"]}},
    "drivers": {"A": {"position": 0}, "B": {"position": 0}}, "want": ["position"]})";
  const std::string column(17, ' ');
  const std::string output = run_assur("solve " + path).output;
  EXPECT_NE(output.find("\n    ä" + column.substr(2) + column + "0" + column + "0"),
            std::string::npos)
      << output;
  EXPECT_NE(output.find("\n    the_longest_of_all_links\n" + column + "   " + column + "1"),
            std::string::npos)
      << output;
}

constexpr std::array subcommands = {"catalogue", "derive", "emit", "solve", "sweep",  "draw",
                                    "import",    "sample", "map",  "merge", "schema", "audit"};

TEST(Help, FitsATerminal) {
  expect_narrow_tables(run_assur("--help").output);
  for (const char* name : subcommands) {
    expect_narrow_tables(run_assur(std::string(name) + " --help").output);
  }
}

TEST(Quiet, IsAnOptionOfEverySubcommand) {
  for (const char* name : subcommands) {
    const std::string help = run_assur(std::string(name) + " --help").output;
    EXPECT_NE(help.find("--quiet"), std::string::npos) << name;
  }
}

TEST(Quiet, LeavesOutRemarks) {
  const std::string swept = "solve " + four_bar + " --format csv --set crank=150";
  const CommandResult loud = run_assur(swept);
  ASSERT_FALSE(loud.messages.empty()) << "the sweep has no stretch without configurations";
  const CommandResult quiet = run_assur(swept + " --quiet");
  EXPECT_EQ(quiet.messages, "");
  EXPECT_EQ(quiet.output, loud.output);
  EXPECT_EQ(quiet.status, loud.status);
}

TEST(Quiet, LeavesErrors) {
  const CommandResult result = run_assur("solve no_such_scene.json --quiet");
  EXPECT_EQ(result.status, 2);
  EXPECT_TRUE(result.messages.starts_with("error: ")) << result.messages;
}

}  // namespace
}  // namespace assur::test::terminal_test
