// Law: emission depends on its input alone, and the files checked in are those that the generator
// emits.
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

#include "command/command.hpp"
#include "whole_campaign.hpp"

namespace assur::test::emission_test {
namespace {

namespace fs = std::filesystem;

/// Every file below a directory, in order, as one text.
std::string whole_tree(const fs::path& directory) {
  std::set<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    if (entry.is_regular_file()) {
      files.insert(entry.path());
    }
  }
  std::string text;
  for (const fs::path& file : files) {
    text += fs::relative(file, directory).string() + "\n" + read_file(file);
  }
  return text;
}

// Each process has its addresses elsewhere (address-space randomisation is the system's default),
// and GiNaC orders by address. Three processes emit all models in this file: the first compares
// them with the checked-in files, the second finds that those are current, and the third finds only
// the planted change. By default the last two emit one model, because the first has compared all.
TEST(Emission, IsTheSameInEveryProcess) {
  const TemporaryDirectory directory;
  ASSERT_EQ(run_assur("emit --all --output " + directory.path().string()).status, 0);
  EXPECT_EQ(whole_tree(directory.path()), whole_tree(ASSUR_GENERATED));
}

TEST(Emission, CheckedInFilesAreCurrent) {
  const std::vector<std::string> chosen = is_whole_campaign()
                                              ? std::vector<std::string>{"--all"}
                                              : std::vector<std::string>{"--model 3 --group dyad"};
  for (const std::string& models : chosen) {
    const CommandResult result =
        run_assur("emit " + models + " --output " ASSUR_GENERATED " --check");
    EXPECT_EQ(result.status, 0) << models << result.messages;
  }
}

TEST(Emission, WritesOneModelOfAGroup) {
  for (const char* path : {"dyad/model_03.hpp", "triad/model_03.hpp", "tetrad/model_03.hpp"}) {
    const TemporaryDirectory directory;
    const std::string group = std::string(path).substr(0, std::string(path).find('/'));
    const std::string chosen = group == "tetrad" ? "" : " --group " + group;
    ASSERT_EQ(run_assur("emit --model 3 --output " + directory.path().string() + chosen).status, 0);
    const std::string header = std::string("assur/") + path;
    EXPECT_EQ(whole_tree(directory.path()),
              header + "\n" + read_file(fs::path(ASSUR_GENERATED) / header));
  }
}

/// The functions that a header has, by the operations that its head states.
std::set<std::string> functions_of(const std::string& header) {
  std::set<std::string> names;
  const std::regex row(R"(///   (\w+): +\d+, \d+, \d+)");
  for (std::sregex_iterator at(header.begin(), header.end(), row), end; at != end; ++at) {
    names.insert((*at)[1]);
  }
  return names;
}

TEST(Emission, HoldsOnRequestWhatTheWordsStandFor) {
  const fs::path header = "assur/tetrad/model_01.hpp";
  const std::set<std::string> own = functions_of(read_file(fs::path(ASSUR_GENERATED) / header));
  const std::map<std::string, std::set<std::string>> added = {
      {"forces", {"forces"}},
      {"jerk", {"jerk_rhs"}},
      {"rates", {"acceleration_rhs", "velocity", "velocity_rhs"}},
      {"special-points",
       {"special_point_accelerations", "special_point_lengths", "special_point_lines",
        "special_point_velocities"}},
      {"rates,jerk", {"acceleration_rhs", "jerk_rhs", "velocity", "velocity_rhs"}}};
  for (const auto& [words, functions] : added) {
    const TemporaryDirectory directory;
    const std::string call = "emit --model 1 --with " + words + " --output ";
    ASSERT_EQ(run_assur(call + directory.path().string()).status, 0);
    std::set<std::string> expected = own;
    expected.insert(functions.begin(), functions.end());
    EXPECT_EQ(functions_of(read_file(directory.path() / header)), expected) << words;
  }
}

TEST(Emission, CheckFindsAChangeAndWritesNothing) {
  const TemporaryDirectory directory;
  const std::string output = directory.path().string();
  fs::copy(ASSUR_GENERATED, directory.path(), fs::copy_options::recursive);
  const std::string changed = "assur/tetrad/model_03.hpp";
  directory.write(changed, "// changed\n");
  const std::string models = is_whole_campaign() ? "--all" : "--model 3";
  const CommandResult result = run_assur("emit " + models + " --output " + output + " --check");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.messages, changed + " differs from what would be written\n");
  EXPECT_EQ(read_file(directory.path() / changed), "// changed\n");
  fs::remove(directory.path() / changed);
  EXPECT_EQ(run_assur("emit " + models + " --output " + output + " --check").messages,
            changed + " does not exist\n");
}

TEST(Emission, CallsNoPowerAndNoTrigonometryAndDoesNotBranch) {
  std::istringstream lines(whole_tree(ASSUR_GENERATED));
  const std::regex quoted("\"[^\"]*\"");
  std::string text;
  std::string line;
  while (std::getline(lines, line)) {
    // Comments and names in quotes may say what they like.
    line = line.substr(0, line.find("//"));
    text +=
        (line.find('"') == std::string::npos ? line : std::regex_replace(line, quoted, "")) + "\n";
  }
  for (const char* forbidden :
       {"pow(", "sin(", "cos(", "tan(", "sqrt(", "if (", "for (", "while (", " ? "}) {
    EXPECT_EQ(text.find(forbidden), std::string::npos) << forbidden;
  }
}

TEST(Emission, LinesFitAHundredColumns) {
  std::istringstream lines(whole_tree(ASSUR_GENERATED));
  std::string line;
  while (std::getline(lines, line)) {
    EXPECT_LE(line.size(), 100U) << line;
  }
}

}  // namespace
}  // namespace assur::test::emission_test
