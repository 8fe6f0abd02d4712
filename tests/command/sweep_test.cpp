// Law: `assur sweep` prints the same as `assur solve --format csv` for a scene with a sweep, and
// refuses a scene without one.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "command/command.hpp"
#include "scenes_of.hpp"
#include "whole_campaign.hpp"

namespace assur::test::sweep_test {
namespace {

using Json = nlohmann::json;

/// An example, one in six by default, and options.
class SweepCommand : public testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(SweepCommand, PrintsTheTableOfSolve) {
  const auto& [name, options] = GetParam();
  const std::string scene = ASSUR_EXAMPLES "/" + name + ".json";
  const std::string call = "sweep " + scene + options;
  const CommandResult swept = run_assur(call);
  if (!Json::parse(read_file(scene)).contains("sweep")) {
    EXPECT_EQ(swept.status, 2);
    EXPECT_EQ(swept.output, "");
    EXPECT_EQ(swept.messages.find("error: " + scene + ": the scene has no sweep; add one"), 0U)
        << swept.messages;
    return;
  }
  const CommandResult solved = run_assur("solve --format csv " + scene + options);
  EXPECT_EQ(swept.status, solved.status);
  EXPECT_EQ(swept.output, solved.output);
  EXPECT_EQ(swept.messages, solved.messages);
  EXPECT_NE(swept.output.find(",event"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SweepCommand,
                         testing::Combine(testing::ValuesIn(share_of(scenes_of(ASSUR_EXAMPLES), 6)),
                                          testing::Values("", " --branch 1", " --unwrapped")),
                         [](const auto& at) {
                           const std::string& options = std::get<1>(at.param);
                           return std::get<0>(at.param) + (options.empty() ? "_all"
                                                           : options == " --branch 1"
                                                               ? "_one"
                                                               : "_unwrapped");
                         });

TEST(SweepCommandAlone, RefusesASceneWithoutSweep) {
  const TemporaryDirectory directory;
  Json scene = Json::parse(read_file(ASSUR_EXAMPLES "/four_bar_coupler_curve.json"));
  scene.erase("sweep");
  const CommandResult result =
      run_assur("sweep " + directory.write("scene.json", scene.dump()).string());
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.output, "");
  EXPECT_NE(result.messages.find("scene.json: the scene has no sweep; add one, as \"sweep\": {"),
            std::string::npos)
      << result.messages;
}

TEST(SweepCommandAlone, RefusesABranchThatDoesNotExist) {
  const CommandResult result = run_assur("sweep " ASSUR_EXAMPLES "/jansen_leg.json --branch 13");
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.output, "");
  EXPECT_NE(result.messages.find("--branch: there is no branch 13; the highest number is 12\n"),
            std::string::npos)
      << result.messages;
}

}  // namespace
}  // namespace assur::test::sweep_test
