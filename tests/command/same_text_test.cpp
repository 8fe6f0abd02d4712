// Law: every process writes the same bytes for the same scene, in every format and in emitted code.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "command/command.hpp"
#include "scenes_of.hpp"
#include "whole_campaign.hpp"

namespace assur::test::same_text_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int processes = 3;

/// One in three of the examples by default.
std::vector<std::string> example_names() { return share_of(scenes_of(ASSUR_EXAMPLES), 3); }

class SameText : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] static fs::path file() { return fs::path(ASSUR_EXAMPLES) / (GetParam() + ".json"); }
};

void expect_same_solutions(const fs::path& scene) {
  for (const char* format : {"text", "json", "csv"}) {
    const std::string arguments = "solve " + scene.string() + " --format " + format;
    const CommandResult first = run_assur(arguments);
    EXPECT_EQ(first.status, 0) << first.messages;
    EXPECT_FALSE(first.output.empty());
    for (int process = 1; process < processes; ++process) {
      EXPECT_TRUE(run_assur(arguments).output == first.output) << format;
    }
  }
}

TEST_P(SameText, OfSolutionsWithASweep) { expect_same_solutions(file()); }

TEST_P(SameText, OfSolutionsWithoutASweep) {
  const TemporaryDirectory directory;
  Json scene = Json::parse(read_file(file()));
  scene.erase("sweep");
  expect_same_solutions(directory.write("scene.json", scene.dump()));
}

/// The text of every file by its path.
std::map<std::string, std::string> emitted(const fs::path& scene) {
  const TemporaryDirectory directory;
  const CommandResult result =
      run_assur("emit --scene " + scene.string() + " --output " + directory.path().string());
  EXPECT_EQ(result.status, 0) << result.messages;
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(directory.path())) {
    if (entry.is_regular_file()) {
      files[fs::relative(entry.path(), directory.path()).string()] = read_file(entry.path());
    }
  }
  return files;
}

TEST_P(SameText, OfEmittedSolvers) {
  const auto first = emitted(file());
  EXPECT_FALSE(first.empty());
  for (int process = 1; process < processes; ++process) {
    EXPECT_TRUE(emitted(file()) == first);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SameText, testing::ValuesIn(example_names()),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace assur::test::same_text_test
