// Law: samples and maps give the same bytes however they are divided into shards, and a request
// that cannot be met is refused in one line, with no file lost or half written.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "command/process.hpp"

namespace assur::test::campaign_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const std::string four_bar = ASSUR_EXAMPLES "/four_bar_coupler_curve.json";
const std::string slider_crank = ASSUR_EXAMPLES "/slider_crank.json";

bool has_hdf5() { return fs::exists(fs::path(ASSUR_COMMAND).parent_path() / "assur_hdf5.so"); }

std::set<std::string> files_in(const fs::path& directory) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

/// Runs commands that write into a temporary folder.
class Campaigns : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const {
    return (directory_.path() / name).string();
  }
  [[nodiscard]] CommandResult run(const std::string& call, const std::string& output,
                                  const std::string& more = "") const {
    return run_assur(call + " --output " + path(output) + " " + more);
  }
  /// The message of a call that must fail, and leave the folder as it was.
  [[nodiscard]] std::string refusal(const std::string& call, const std::string& output,
                                    const std::string& more = "") const {
    const std::set<std::string> before = files_in(directory_.path());
    const CommandResult result = run(call, output, more);
    EXPECT_EQ(result.status, 2) << call;
    EXPECT_EQ(result.output, "");
    EXPECT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'), 1)
        << result.messages;
    EXPECT_EQ(files_in(directory_.path()), before) << call;
    return result.messages;
  }
  [[nodiscard]] std::string read(const std::string& name) const { return read_file(path(name)); }

  TemporaryDirectory directory_;
};

const std::string sample = "sample " + four_bar + " --seed 1 --count 3000";
const std::string map = "map " + four_bar + " --over 'phi=0:2*pi:13,ground=20:280:17'";

TEST_F(Campaigns, GiveTheSameBytesInAnyParts) {
  std::vector<std::string> endings = {".csv"};
  if (has_hdf5()) {
    endings.emplace_back(".h5");
  }
  for (const std::string& call : {sample, map}) {
    for (const std::string& ending : endings) {
      const std::string whole = "whole" + ending;
      const CommandResult summary = run(call, whole, "--threads 1 --force");
      ASSERT_EQ(summary.status, 0) << summary.messages;
      for (const int count : {2, 5}) {
        std::string files;
        for (int number = count; number >= 1; --number) {
          const std::string name = "part" + std::to_string(number) + ending;
          const std::string shard = std::to_string(number) + "/" + std::to_string(count);
          ASSERT_EQ(run(call, name, "--force --threads 2 --shard " + shard).status, 0);
          files += " " + path(name);
        }
        const CommandResult merged = run("merge" + files, "merged" + ending, "--force");
        EXPECT_EQ(merged.status, 0) << merged.messages;
        EXPECT_EQ(merged.output, summary.output);
        EXPECT_TRUE(read("merged" + ending) == read(whole)) << call;
      }
    }
    if (has_hdf5()) {  // one format into the other, and back
      ASSERT_EQ(run("merge " + path("whole.csv"), "turned.h5", "--force").status, 0);
      EXPECT_TRUE(read("turned.h5") == read("whole.h5"));
      ASSERT_EQ(run("merge " + path("turned.h5"), "turned.csv", "--force").status, 0);
      EXPECT_TRUE(read("turned.csv") == read("whole.csv"));
    }
  }
}

TEST_F(Campaigns, TellAFileThatIsWholeFromAnother) {
  const CommandResult first = run(sample, "a.csv");
  ASSERT_EQ(first.status, 0);
  const std::string bytes = read("a.csv");
  const CommandResult again = run(sample, "a.csv");
  EXPECT_EQ(again.status, 0);
  EXPECT_EQ(again.output, first.output);
  EXPECT_EQ(again.messages, path("a.csv") + ": the table is complete and is not computed again\n");
  EXPECT_EQ(refusal("sample " + four_bar + " --seed 2 --count 3000", "a.csv"),
            "error: " + path("a.csv") +
                ": the file exists and holds another table (seed: 1 instead of 2); give another "
                "name, or --force to replace it\n");
  EXPECT_EQ(read("a.csv"), bytes);
  (void)directory_.write("notes.csv", "my notes\n");
  EXPECT_NE(refusal(sample, "notes.csv").find(": the file exists; give another name"),
            std::string::npos);
  EXPECT_EQ(read("notes.csv"), "my notes\n");
  EXPECT_EQ(run(sample, "notes.csv", "--force").status, 0);
  EXPECT_EQ(read("notes.csv"), bytes);
}

TEST_F(Campaigns, RefuseWhatCannotBeUsed) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {sample + " --shard 9/8", "--shard: '9/8' is not a part"},
      {sample + " --shard 0/8", "--shard: '0/8' is not a part"},
      {sample + " --shard 1", "--shard: '1' is not a part"},
      {sample + " --branch 3", ": --branch: there is no configuration 3; the highest number is 2"},
      {"sample " + four_bar + " --seed 1 --count 0", "--count: expected a whole number from 1"},
      {"sample " + four_bar + " --seed 1 --count 1e99", "--count: expected a whole number"},
      {"sample " + four_bar + " --seed -1 --count 3", "--seed: expected a whole number from 0"},
      {"sample gone.json --seed 1 --count 3", "gone.json: "},
      {"map " + four_bar + " --over phi=0:1:1e6,ground=1:2:1e6", "more than 1e8 cells"},
      {"map " + four_bar + " --over phi=0:1", "'phi=0:1' is not an axis"},
      {"map " + four_bar + " --over phi=0:1:0",
       "--over phi: COUNT: expected a whole number from 1"},
      {"map " + four_bar + " --over ph=0:1:3", "no parameter named 'ph'"},
      {"map " + four_bar + " --set phi=1 --over phi=0:1:3",
       "--set phi: --over gives 'phi' its values; leave one of the two out"},
      {"map " + four_bar + " --over phi=-1e308:1e308:3", "the range from FROM to TO"}};
  for (const auto& [call, message] : cases) {
    EXPECT_NE(refusal(call, "x.csv").find(message), std::string::npos) << call;
  }
  EXPECT_NE(refusal(sample, "x.txt").find("extension '.txt' is not known; give .csv, .h5 or .svg"),
            std::string::npos);
  EXPECT_NE(refusal(sample, "x.svg", "--shard 1/2").find("a single shard has no picture"),
            std::string::npos);
  for (const auto& [file, options] : std::vector<std::pair<std::string, std::string>>{
           {"gone/x.csv", ""}, {"gone/x.svg", ""}, {"x.csv", "--plot gone/x.svg"}}) {
    EXPECT_NE(refusal(sample, file, options).find("there is no directory "), std::string::npos);
  }
  // The first name is too long for a file, and the link leads to itself: nothing is computed.
  const std::string longest(300, 'a');
  fs::create_symlink(path("circle.csv"), path("circle.csv"));
  for (const auto& [file, options] : std::vector<std::pair<std::string, std::string>>{
           {longest + ".csv", ""},
           {longest + ".svg", ""},
           {"x.csv", "--plot " + path(longest + ".svg")},
           {"circle.csv", "--force"}}) {
    EXPECT_NE(refusal(sample, file, options).find(" cannot be written: "), std::string::npos)
        << file;
    EXPECT_FALSE(fs::exists(path("x.csv")));
  }
  EXPECT_NE(
      refusal("merge " + four_bar, "x.csv").find("give tables that sample or map has written"),
      std::string::npos);
  if (!has_hdf5()) {
    EXPECT_NE(refusal(sample, "x.h5").find("built without HDF5"), std::string::npos);
  }
}

TEST_F(Campaigns, RefuseDirectoriesBeforeTheyCompute) {
  fs::create_directory(path("folder.csv"));
  EXPECT_NE(refusal(sample, "folder.csv", "--force").find("it is a directory; give another name"),
            std::string::npos);
}

TEST_F(Campaigns, DoNotReplaceWhatTheyRead) {
  const std::string scene = read_file(four_bar);
  (void)directory_.write("scene.csv", scene);
  const std::string of_scene = "sample " + path("scene.csv") + " --seed 1 --count 3 --force";
  EXPECT_NE(refusal(of_scene, "scene.csv").find(": writing it would replace the input "),
            std::string::npos);
  EXPECT_EQ(read("scene.csv"), scene);
  // While a table is written, the name of its file ends in `.partial`.
  (void)directory_.write("x.csv.partial", scene);
  EXPECT_NE(refusal("sample " + path("x.csv.partial") + " --seed 1 --count 3", "x.csv")
                .find(": writing it would replace the input "),
            std::string::npos);
  EXPECT_EQ(read("x.csv.partial"), scene);
  for (const std::string shard : {"1", "2"}) {
    ASSERT_EQ(run(sample, shard + ".csv", "--shard " + shard + "/2").status, 0);
  }
  const std::string first = read("1.csv");
  EXPECT_NE(refusal("merge --force " + path("1.csv") + " " + path("2.csv"), "1.csv")
                .find(": writing it would replace the input "),
            std::string::npos);
  EXPECT_EQ(read("1.csv"), first);
}

TEST_F(Campaigns, MergeOnlyWhatBelongsTogether) {
  for (const std::string shard : {"1", "2", "3"}) {
    ASSERT_EQ(run(sample, shard + ".csv", "--shard " + shard + "/3").status, 0);
  }
  ASSERT_EQ(
      run("sample " + slider_crank + " --seed 1 --count 3000", "other.csv", "--shard 2/3").status,
      0);
  ASSERT_EQ(run(sample, "half.csv", "--shard 1/2").status, 0);
  (void)directory_.write("cut.csv", read("2.csv").substr(0, read("2.csv").size() - 5));
  (void)directory_.write(
      "short.csv",
      read("2.csv").substr(0, read("2.csv").rfind('\n', read("2.csv").size() - 2) + 1));
  const auto merging = [&](const std::vector<std::string>& names) {
    std::string call = "merge";
    for (const std::string& name : names) {
      call += " " + path(name);
    }
    return refusal(call, "merged.csv");
  };
  EXPECT_EQ(merging({"3.csv", "1.csv"}),
            "error: 1 of 3 shards is missing: 2/3; compute it with --shard\n");
  EXPECT_NE(merging({"1.csv", "other.csv", "3.csv"}).find("not a part of the same campaign"),
            std::string::npos);
  EXPECT_NE(merging({"1.csv", "2.csv", "2.csv"}).find("2.csv: it is given twice"),
            std::string::npos);
  EXPECT_NE(merging({"1.csv", "half.csv"}).find("it is shard 1/2, and"), std::string::npos);
  EXPECT_NE(merging({"1.csv", "cut.csv", "3.csv"}).find("ends within a line"), std::string::npos);
  EXPECT_NE(
      merging({"1.csv", "short.csv", "3.csv"}).find("the table is incomplete: it ends at item"),
      std::string::npos);
  std::string forged = read("1.csv");
  forged.replace(forged.find("whole outcome"), 13, "whole whole");
  forged = std::regex_replace(forged, std::regex(",regular,"), ",99,");
  (void)directory_.write("forged.csv", std::regex_replace(forged, std::regex("1/3"), "1/1"));
  EXPECT_NE(merging({"forged.csv"}).find("its columns differ"), std::string::npos);
  EXPECT_NE(merging({"1.csv", "gone.csv"}).find("gone.csv: "), std::string::npos);
}

TEST_F(Campaigns, LeaveNothingOnAFullDisk) {
  std::vector<std::string> names = {"a.csv"};
  if (has_hdf5()) {
    names.emplace_back("a.h5");
  }
  for (const std::string& name : names) {
    const ProcessResult result =
        run_process({"sample", four_bar, "--seed", "1", "--count", "3000", "--output", path(name)},
                    opened("/dev/null"), 50000);
    EXPECT_EQ(result.status, 2) << name;
    EXPECT_EQ(result.messages, "error: " + path(name) + ": cannot be written: File too large\n");
    EXPECT_TRUE(files_in(directory_.path()).empty()) << name;
  }
  const ProcessResult full =
      run_process({"sample", four_bar, "--seed", "1", "--count", "30", "--output", path("b.csv")},
                  opened("/dev/full"));
  EXPECT_EQ(full.status, 2);
  EXPECT_TRUE(full.messages.starts_with("error: standard output"));
  EXPECT_EQ(files_in(directory_.path()), std::set<std::string>{"b.csv"});  // the rows are kept
}

/// There is room for the table, and not for the picture.
TEST_F(Campaigns, WriteATableAndItsPictureOrNeither) {
  const auto sampled = [&](const std::string& seed, unsigned long largest_file) {
    return run_process({"sample", four_bar, "--seed", seed, "--count", "30", "--force", "--output",
                        path("a.csv"), "--plot", path("a.svg")},
                       opened("/dev/null"), largest_file);
  };
  const auto expect_refusal = [&] {
    const ProcessResult result = sampled("2", 8192);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.messages, "error: " + path("a.svg") + ": cannot be written: File too large\n");
  };
  expect_refusal();
  EXPECT_TRUE(files_in(directory_.path()).empty());
  ASSERT_EQ(sampled("1", 0).status, 0);
  const std::string table = read("a.csv");
  const std::string picture = read("a.svg");
  expect_refusal();
  EXPECT_EQ(files_in(directory_.path()), (std::set<std::string>{"a.csv", "a.svg"}));
  EXPECT_EQ(read("a.csv"), table);
  EXPECT_EQ(read("a.svg"), picture);
  EXPECT_EQ(sampled("2", 0).status, 0);
  EXPECT_NE(read("a.csv"), table);
  EXPECT_NE(read("a.svg"), picture);
  EXPECT_EQ(files_in(directory_.path()), (std::set<std::string>{"a.csv", "a.svg"}));
}

TEST_F(Campaigns, SummariseAsJson) {
  const Json drawn = Json::parse(run(sample, "p.svg", "--format json").output);
  EXPECT_TRUE(read("p.svg").starts_with("<svg"));
  EXPECT_EQ(drawn["samples"], 3000);
  EXPECT_EQ(drawn["outcomes"]["regular"], 3000);
  const Json& point = drawn["outputs"]["P"];
  for (const std::size_t axis : {0U, 1U}) {
    const double worst = point["worst_case"][axis];
    EXPECT_LT(point["greatest"][axis], 1.01 * worst);  // worst_case is of first order
    EXPECT_GT(point["least"][axis], -1.01 * worst);
    const double deviation = point["deviation_first_order"][axis];
    EXPECT_NEAR(point["deviation"][axis], deviation, 5 * deviation / std::sqrt(2.0 * 3000));
    EXPECT_NEAR(point["mean_shift"][axis], point["mean_shift_second_order"][axis],
                5 * deviation / std::sqrt(3000.0));
  }
  std::uint64_t counted = 0;
  for (const Json& bar : point["histogram_x"]) {
    counted += bar["count"].get<std::uint64_t>();
  }
  EXPECT_EQ(counted, 3000U);
  const Json cells = Json::parse(run(map, "m.svg", "--format json").output);
  EXPECT_TRUE(read("m.svg").starts_with("<svg"));
  EXPECT_EQ(cells["cells"], 13 * 17);
  EXPECT_GT(cells["changes"], 10);
}

TEST_F(Campaigns, SurviveOddNames) {
  Json scene = Json::parse(read_file(four_bar));
  scene["name"] = "a\nname: with \"lines\" & <marks>";
  scene["outputs"] = {{"P,\"x\"\n/", "coupler.P"}, {"..", "coupler.C"}, {"P_", "coupler.P"}};
  const std::string file = directory_.write("odd.json", scene.dump()).string();
  std::vector<std::string> endings = {".csv"};
  if (has_hdf5()) {
    endings.emplace_back(".h5");
  }
  for (const std::string& ending : endings) {
    const std::string call = "sample " + file + " --seed 1 --count 300";
    ASSERT_EQ(run(call, "a" + ending).status, 0);
    std::string files;
    for (const std::string shard : {"1", "2"}) {
      ASSERT_EQ(run(call, shard + ending, "--shard " + shard + "/2").status, 0);
      files += " " + path(shard + ending);
    }
    const CommandResult merged =
        run("merge" + files, "m" + ending, "--plot " + path("m.svg") + " --force");
    EXPECT_EQ(merged.status, 0) << merged.messages;
    EXPECT_TRUE(read("m" + ending) == read("a" + ending));
  }
}

}  // namespace
}  // namespace assur::test::campaign_test
