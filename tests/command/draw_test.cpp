// Law: a drawing that cannot be made or written is refused in one line with exit status 2 and
// leaves every file unchanged; a drawing has the same text wherever it is written.
#include <gtest/gtest.h>

#include <algorithm>

#include "command/process.hpp"

namespace assur::test::draw_test {
namespace {

namespace fs = std::filesystem;

const std::string four_bar = ASSUR_EXAMPLES "/four_bar_coupler_curve.json";
/// A driven parallelogram, and at its pin B two links of no length that turn freely.
const std::string parallelogram = R"({
  "links": {"ground": {"A": [0, 0], "D": [4, 0]}, "crank": {"A": [0, 0], "B": [1, 0]},
            "coupler": {"B": [0, 0], "C": [4, 0]}, "rocker": {"D": [0, 0], "C": [1, 0]},
            "bar": {"B": [0, 0], "E": [0, 0]}, "end": {"E": [0, 0], "B": [0, 0]}},
  "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
             "B": {"type": "revolute", "between": ["crank.B", "coupler.B"]},
             "C": {"type": "revolute", "between": ["coupler.C", "rocker.C"]},
             "D": {"type": "revolute", "between": ["ground.D", "rocker.D"]},
             "E": {"type": "revolute", "between": ["bar.E", "end.E"]},
             "F": {"type": "revolute", "between": ["bar.B", "crank.B"]},
             "G": {"type": "revolute", "between": ["end.B", "coupler.B"]}},
  "drivers": {"A": {"position": 1}}
})";

std::size_t entries_in(const fs::path& directory) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(directory), fs::directory_iterator()));
}

void expect_refusal(const std::string& arguments, const std::string& file,
                    const std::string& expected) {
  const TemporaryDirectory directory;
  const CommandResult result =
      run_assur("draw " + arguments + " --output " + (directory.path() / file).string());
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.output, "");
  EXPECT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'), 1) << result.messages;
  EXPECT_EQ(result.messages.rfind("error: ", 0), 0U) << result.messages;
  EXPECT_NE(result.messages.find(expected), std::string::npos) << result.messages;
  EXPECT_EQ(entries_in(directory.path()), 0U);
}

TEST(Draw, RefusesWhatIsNoForm) {
  expect_refusal(four_bar, "picture.svgg", "no drawing has the extension '.svgg'");
  expect_refusal(four_bar, "picture.svgg", "(did you mean '.svg'?)");
  expect_refusal(four_bar, "picture", "the name has no extension; the extensions are .svg");
}

TEST(Draw, RefusesWhatHasNoConfiguration) {
  expect_refusal(four_bar + " --set coupler=1 --set rocker=1", "picture.svg",
                 "four_bar_coupler_curve.json: there is nothing to draw: no-assembly: group 1");
  expect_refusal(four_bar + " --configuration 3", "picture.dxf",
                 "four_bar_coupler_curve.json: --configuration: there is no configuration 3; the "
                 "highest number is 2");
  expect_refusal(four_bar + " --nearest", "picture.svg", "reference");
  expect_refusal(four_bar + " --configuration 0", "picture.svg", "expected a whole number");
  expect_refusal("none.json", "picture.svg", "none.json");
}

TEST(Draw, RefusesADirectoryThatDoesNotExist) {
  const TemporaryDirectory directory;
  const std::string file = (directory.path() / "gone" / "picture.svg").string();
  const CommandResult result = run_assur("draw " + four_bar + " --output " + file);
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.messages, "error: " + file + ": there is no directory " +
                                 (directory.path() / "gone").string() +
                                 "; make it, or name another one\n");
  EXPECT_EQ(entries_in(directory.path()), 0U);
}

TEST(Draw, DoesNotReplaceTheScene) {
  const TemporaryDirectory directory;
  const std::string scene = read_file(four_bar);
  const std::string file = directory.write("scene.svg", scene).string();
  const CommandResult result = run_assur("draw " + file + " --output " + file);
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.messages, "error: " + file + ": writing it would replace the input " + file +
                                 "; give another name\n");
  EXPECT_EQ(read_file(file), scene);
}

TEST(Draw, RefusesOptionsOfOtherForms) {
  expect_refusal(four_bar + " --moving", "picture.dxf",
                 "--moving: only an .svg can be drawn in motion");
  expect_refusal(four_bar + " --moving", "picture.html",
                 "--moving: only an .svg can be drawn in motion");
  expect_refusal(four_bar + " --nearest", "picture.html", "a page opens on the branch nearest");
  expect_refusal(four_bar + " --configuration 5", "picture.html",
                 "--configuration: there is no branch 5");
  expect_refusal(four_bar + " --moving --configuration 5", "picture.svg",
                 "--configuration: there is no branch 5");
}

TEST(Draw, RefusesWhatMovesFreely) {
  const TemporaryDirectory directory;
  const std::string scene = directory.write("scene.json", parallelogram).string();
  expect_refusal(scene, "picture.svg", "scene.json: there is nothing to draw: degenerate: ");
}

TEST(Draw, LeavesWhatWasThereOnAFullDisk) {
  const TemporaryDirectory directory;
  const fs::path file = directory.write("picture.svg", "what was there\n");
  const ProcessResult result =
      run_process({"draw", four_bar, "--output", file.string()}, opened("/dev/null"), 4096);
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.messages.find(" cannot be written: "), std::string::npos) << result.messages;
  EXPECT_EQ(read_file(file), "what was there\n");
  EXPECT_EQ(entries_in(directory.path()), 1U);
}

TEST(Draw, RefusesADirectory) {
  const TemporaryDirectory directory;
  fs::create_directory(directory.path() / "picture.svg");
  const CommandResult result =
      run_assur("draw " + four_bar + " --output " + (directory.path() / "picture.svg").string());
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.messages.find("it is a directory"), std::string::npos) << result.messages;
}

TEST(Draw, WritesTheSameFileWhereverItIsCalled) {
  const TemporaryDirectory directory;
  const std::string away = (directory.path() / "new" / "one.svg").string();
  fs::create_directory(directory.path() / "new");
  EXPECT_EQ(run_assur("draw " + four_bar + " --output " + away).status, 0);
  EXPECT_EQ(
      run_assur("draw " + four_bar + " --output " + (directory.path() / "two.svg").string()).status,
      0);
  EXPECT_EQ(read_file(away), read_file(directory.path() / "two.svg"));
  const fs::path before = fs::current_path();
  fs::current_path(directory.path());
  const CommandResult here = run_assur("draw " + four_bar + " --output here.svg");
  fs::current_path(before);
  EXPECT_EQ(here.status, 0) << here.messages;
  EXPECT_EQ(read_file(away), read_file(directory.path() / "here.svg"));
}

}  // namespace
}  // namespace assur::test::draw_test
