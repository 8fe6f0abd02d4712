// Law: a command that cannot write its output ends with exit status 2 and one line that says so
// (none if a pipe was closed), and leaves no part of a file behind.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "command/process.hpp"
#include "whole_campaign.hpp"

namespace assur::test::output_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const std::string four_bar = ASSUR_EXAMPLES "/four_bar_coupler_curve.json";
const std::string audited = ASSUR_EXAMPLES "/audit/mitsi_tetrad_kinds.audit";

/// A command line that prints.
struct Printing {
  const char* name;
  std::vector<std::string> arguments;
};

class UnwritableOutput : public testing::TestWithParam<Printing> {};

void expect_refusal(const ProcessResult& result) {
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'), 1) << result.messages;
  EXPECT_TRUE(result.messages.starts_with("error: standard output")) << result.messages;
}

TEST_P(UnwritableOutput, ToAFullDeviceIsRefused) {
  expect_refusal(run_process(GetParam().arguments, opened("/dev/full")));
}

TEST_P(UnwritableOutput, ToAClosedPipeEndsWithoutAWord) {
  const ProcessResult result = run_process(GetParam().arguments, closed_pipe());
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.messages, "");
}

/// A descriptor that is open for reading only fails as a full device does.
TEST_P(UnwritableOutput, ToADescriptorThatIsReadIsRefused) {
  expect_refusal(run_process(GetParam().arguments, open("/dev/null", O_RDONLY | O_CLOEXEC)));
}

/// The commands that print to the unwritable output. The catalogue takes a second to derive, so by
/// default only one of its formats is printed.
std::vector<Printing> printings() {
  std::vector<Printing> all = {
      {"SolveText", {"solve", four_bar}},
      {"SolveJson", {"solve", four_bar, "--format", "json"}},
      {"SolveSweep", {"solve", four_bar, "--format", "csv"}},
      {"Derive", {"derive", "RRP"}},
      {"DeriveLatex", {"derive", "RRP", "--format", "latex"}},
      {"DeriveJson", {"derive", "RRP", "--format", "json"}},
      {"Catalogue", {"catalogue"}},
      {"Audit", {"audit", audited}},
      {"AuditMarkdown", {"audit", audited, "--format", "markdown"}},
      {"AuditJson", {"audit", audited, "--format", "json"}},
      {"AuditGithub", {"audit", audited, "--format", "github"}},
      {"Schema", {"schema"}},
      {"Help", {"solve", "--help"}},
      {"Version", {"--version"}},
  };
  if (is_whole_campaign()) {
    all.push_back({"CatalogueMarkdown", {"catalogue", "--format", "markdown"}});
    all.push_back({"CatalogueJson", {"catalogue", "--format", "json"}});
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Command, UnwritableOutput, testing::ValuesIn(printings()),
                         [](const auto& printing) { return std::string(printing.param.name); });

std::size_t files_in(const fs::path& directory) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(directory)) {
    count += entry.is_regular_file() ? 1 : 0;
  }
  return count;
}

/// `emit` prints nothing, so its standard output does not matter.
TEST(EmittedOutput, IsWholeWhateverTheStandardOutputIs) {
  const TemporaryDirectory reference;
  EXPECT_EQ(run_assur("emit --scene " + four_bar + " --output " + reference.path().string()).status,
            0);
  const fs::path name = "assur/scenes/four_bar_coupler_curve.hpp";
  for (const int output : {opened("/dev/full"), closed_pipe()}) {
    const TemporaryDirectory directory;
    const ProcessResult result =
        run_process({"emit", "--scene", four_bar, "--output", directory.path().string()}, output);
    EXPECT_EQ(result.status, 0) << result.messages;
    EXPECT_EQ(result.messages, "");
    EXPECT_FALSE(read_file(directory.path() / name).empty());
    EXPECT_EQ(read_file(directory.path() / name), read_file(reference.path() / name));
  }
}

void expect_refusal_of_directory(const ProcessResult& result) {
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'), 1) << result.messages;
  EXPECT_TRUE(result.messages.starts_with("error: --output: ")) << result.messages;
  EXPECT_NE(result.messages.find(" cannot be written: "), std::string::npos) << result.messages;
}

TEST(EmittedOutput, OnAFullDiskLeavesNoFile) {
  const TemporaryDirectory directory;
  expect_refusal_of_directory(
      run_process({"emit", "--scene", four_bar, "--output", directory.path().string()},
                  opened("/dev/null"), 4096));
  EXPECT_EQ(files_in(directory.path()), 0U);
}

TEST(EmittedOutput, OnAFullDiskKeepsTheFileThatWasThere) {
  const TemporaryDirectory directory;
  const fs::path file = directory.path() / "assur/scenes/four_bar_coupler_curve.hpp";
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "what was there\n";
  expect_refusal_of_directory(
      run_process({"emit", "--scene", four_bar, "--output", directory.path().string()},
                  opened("/dev/null"), 4096));
  EXPECT_EQ(read_file(file), "what was there\n");
  EXPECT_EQ(files_in(directory.path()), 1U);
}

/// In these places nobody can make a directory, not even root.
TEST(EmittedOutput, InAReadOnlyPlaceIsRefused) {
  const TemporaryDirectory directory;
  const fs::path file = directory.write("file", "");
  for (const std::string& place : {std::string("/proc/emitted"), (file / "below").string()}) {
    expect_refusal_of_directory(
        run_process({"emit", "--scene", four_bar, "--output", place}, opened("/dev/null")));
    EXPECT_FALSE(fs::exists(place));
  }
}

TEST(EmittedOutput, DoesNotReplaceTheSceneThatItReads) {
  const TemporaryDirectory directory;
  const fs::path file = directory.path() / "assur/scenes/four_bar.hpp";
  fs::create_directories(file.parent_path());
  fs::copy_file(four_bar, file);
  const ProcessResult result =
      run_process({"emit", "--scene", file.string(), "--output", directory.path().string()},
                  opened("/dev/null"));
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.messages.find(": writing it would replace the input "), std::string::npos)
      << result.messages;
  EXPECT_EQ(read_file(file), read_file(four_bar));
}

ProcessResult emitted_in_c(const TemporaryDirectory& directory, unsigned long largest_file = 0) {
  return run_process(
      {"emit", "--scene", four_bar, "--interface", "c", "--output", directory.path().string()},
      opened("/dev/null"), largest_file);
}

/// The contents of the files that `emit --interface c` replaces.
std::map<std::string, std::string> texts_in(const TemporaryDirectory& directory) {
  std::map<std::string, std::string> texts;
  for (const auto& entry : fs::recursive_directory_iterator(directory.path())) {
    if (entry.is_regular_file()) {
      texts[entry.path().lexically_relative(directory.path()).string()] = read_file(entry.path());
    }
  }
  return texts;
}

TEST(EmittedOutput, OfThreeFilesIsAllOrNone) {
  const std::string name = "assur/scenes/four_bar_coupler_curve.";
  for (const std::string taken : {"hpp", "h", "cpp"}) {
    const TemporaryDirectory directory;
    fs::create_directories(directory.path() / (name + taken) / "below");
    std::map<std::string, std::string> old;
    for (const std::string ending : {"hpp", "h", "cpp"}) {
      if (ending != taken) {
        (void)directory.write(name + ending, old[name + ending] = "old " + ending);
      }
    }
    expect_refusal_of_directory(emitted_in_c(directory));
    EXPECT_EQ(texts_in(directory), old) << taken;
  }
  // There is room for one file or two, and not for the header in C++.
  for (const unsigned long room : {4096UL, 8192UL}) {
    const TemporaryDirectory directory;
    expect_refusal_of_directory(emitted_in_c(directory, room));
    EXPECT_TRUE(fs::is_empty(directory.path()));
    EXPECT_EQ(emitted_in_c(directory).status, 0);
    const auto whole = texts_in(directory);
    EXPECT_EQ(whole.size(), 3U);
    expect_refusal_of_directory(emitted_in_c(directory, room));
    EXPECT_EQ(texts_in(directory), whole);
  }
}

TEST(EmittedOutput, WhereADirectoryHasItsNameLeavesNoFile) {
  const TemporaryDirectory directory;
  fs::create_directories(directory.path() / "assur/scenes/four_bar_coupler_curve.hpp/below");
  expect_refusal_of_directory(run_process(
      {"emit", "--scene", four_bar, "--output", directory.path().string()}, opened("/dev/null")));
  EXPECT_EQ(files_in(directory.path()), 0U);
}

}  // namespace
}  // namespace assur::test::output_test
