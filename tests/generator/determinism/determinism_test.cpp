// Law: every command prints the same bytes in processes with different addresses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "command/command.hpp"
#include "whole_campaign.hpp"

namespace assur::test::determinism_test {
namespace {

/// How often each call runs.
int processes() { return is_whole_campaign() ? 3 : 2; }

/// The call's arguments. `OUTPUT` stands for a new directory, whose files are compared, too;
/// `EXAMPLES` and `HERE` stand for the directories of the examples and of this test.
struct Call {
  std::string name;
  std::string arguments;
};

/// By default papers are left out, which take longer than all else, and files that take a second
/// are audited in one format: `ctest -L long` audits all of them in every format.
std::vector<Call> calls() {
  const std::string paper =
      std::string("EXAMPLES/audit/") + (is_whole_campaign() ? "zhauyt_2017" : "mitsi_tetrad_kinds");
  std::vector<Call> list = {
      {"EmitModel", "emit --model 2 --output OUTPUT"},
      {"EmitVariable", "emit --scene HERE/variable.json --output OUTPUT"},
      {"EmitClosures",
       "emit --closures EXAMPLES/audit/own_model/gear_five_bar.audit --output OUTPUT"},
      {"EmitDifferences", "emit --closures HERE/differences.audit --output OUTPUT"},
      {"AuditPaper", "audit " + paper + ".tex --map " + paper + ".map"},
      {"Schema", "schema"},
      {"Help", "emit --help"}};
  for (const std::string format : {"text", "markdown", "json"}) {
    list.push_back({"Catalogue_" + format, "catalogue --format " + format});
  }
  for (const std::string format : {"text", "markdown", "json", "github"}) {
    std::vector<std::string> files = {"EXAMPLES/audit/mitsi_tetrad_kinds",
                                      "EXAMPLES/audit/own_model/gear_five_bar"};
    if (is_whole_campaign() || format == "text") {
      files.push_back("HERE/differences");
    }
    if (is_whole_campaign()) {
      files.insert(files.end(), {"EXAMPLES/audit/quintero_2011", "EXAMPLES/audit/zhauyt_2017"});
    }
    for (const std::string& file : files) {
      list.push_back({"Audit_" + std::filesystem::path(file).filename().string() + "_" + format,
                      "audit " + file + ".audit --format " + format});
    }
  }
  for (const std::string format : {"text", "latex", "json"}) {
    for (const std::string& model :
         share_of(std::vector<std::string>{"7", "--group dyad 2", "2", "--group triad 3"}, 2)) {
      std::string name = "Derive_" + model + "_" + format;
      std::erase(name, '-');
      std::replace(name.begin(), name.end(), ' ', '_');
      list.push_back({name, "derive " + model + " --format " + format});
    }
  }
  return list;
}

std::string with(std::string text, const std::string& word, const std::string& meaning) {
  for (std::size_t at = text.find(word); at != std::string::npos;
       at = text.find(word, at + meaning.size())) {
    text.replace(at, word.size(), meaning);
  }
  return text;
}

/// Moves the stack by the size of the environment and fills and divides the heap in other ways.
void disturb(int process) {
  setenv("ASSUR_TEST_PADDING",
         std::string(static_cast<std::size_t>(1 + 7919 * process), 'x').c_str(), 1);
  setenv("MALLOC_PERTURB_", std::to_string(process * 85 % 256).c_str(), 1);
  setenv("MALLOC_TOP_PAD_", std::to_string(process * 77777).c_str(), 1);
  setenv("MALLOC_MMAP_THRESHOLD_", std::to_string(4096 << process).c_str(), 1);
}

/// All that a call gives: its status, both its outputs and its files.
std::string everything(const Call& call) {
  const TemporaryDirectory directory;
  const std::string output = (directory.path() / "output").string();
  std::string arguments = with(call.arguments, "OUTPUT", output);
  arguments = with(with(arguments, "EXAMPLES", ASSUR_EXAMPLES), "HERE", ASSUR_HERE);
  const CommandResult result = run_assur(arguments);
  EXPECT_LE(result.status, 2) << arguments;
  EXPECT_GE(result.status, 0) << arguments;
  std::string all = std::to_string(result.status) + "\n" + result.output +
                    with(result.messages, output, "OUTPUT");
  if (std::filesystem::exists(output)) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(output)) {
      if (entry.is_regular_file()) {
        files.push_back(entry.path());
      }
    }
    std::sort(files.begin(), files.end());
    for (const std::filesystem::path& file : files) {
      all += file.lexically_relative(output).generic_string() + "\n" + read_file(file);
    }
  }
  return all;
}

class Determinism : public testing::TestWithParam<Call> {};

TEST_P(Determinism, SameBytesInEveryProcess) {
  disturb(0);
  const std::string first = everything(GetParam());
  EXPECT_GT(first.size(), 10U);
  for (int process = 1; process < processes(); ++process) {
    disturb(process);
    ASSERT_EQ(everything(GetParam()), first) << GetParam().arguments;
  }
}

INSTANTIATE_TEST_SUITE_P(Commands, Determinism, testing::ValuesIn(calls()),
                         [](const auto& call) { return call.param.name; });

}  // namespace
}  // namespace assur::test::determinism_test
