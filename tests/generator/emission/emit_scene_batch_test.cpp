// Law: an emitted solver finds the same in a batch of driver positions as in single calls.
#include <gtest/gtest.h>

#include <sstream>

#include "generator/scene_files.hpp"
#include "generator/solver_comparison.hpp"
#include "whole_campaign.hpp"

namespace assur::test::emit_scene_batch_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A scene with limits on a slide that leave some configurations out. In the whole campaign it has
/// two dyads, and limits on a pin, too; otherwise it wants less, so that less is compiled.
EmittedScene limited(const TemporaryDirectory& directory, bool whole) {
  const std::string example = whole ? "shaper_quick_return.json" : "slider_crank.json";
  Json scene = scene_json(fs::path(ASSUR_EXAMPLES) / example);
  scene["joints"][whole ? "B" : "S"]["limits"] = {0, 1000};
  if (whole) {
    scene["joints"]["C"]["limits"] = {0, 3};
  } else {
    scene["want"] = {"position", "velocity"};
  }
  return {directory.write("limited.json", scene.dump()), "limited", "Limited", {}};
}

std::vector<EmittedScene> examples() {
  std::vector<EmittedScene> scenes;
  for (const fs::path& file : scene_files({ASSUR_EXAMPLES, ASSUR_SCENES})) {
    scenes.push_back({file, file.stem().string(), struct_of(file.stem().string()), {}});
  }
  return scenes;
}

/// Where products and sums are not contracted, groups that are solved by formula give the same
/// numbers bit by bit; other groups agree to six digits, as `ok` promises. By default one scene.
TEST(EmitSceneBatch, FindsWhatSingleCallsFind) {
  const bool whole = is_whole_campaign();
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  std::vector<EmittedScene> scenes = {limited(directory, whole)};
  if (whole) {
    const std::vector<EmittedScene> all = examples();
    scenes.insert(scenes.end(), all.begin(), all.end());
  }
  std::string source = "#define ASSUR_INSTANCES " + std::string(whole ? "20000" : "2000") + "\n";
  std::string calls;
  for (const EmittedScene& scene : scenes) {
    emit_solver(scene, directory);
    source += "#include <assur/scenes/" + scene.header + ".hpp>\n";
    calls += "  batch_scenes::print_differences<assur::scenes::" + scene.solver + ">(\"" +
             scene.solver + "\");\n";
  }
  source += "#include <assur/support/track_batch.hpp>\n#include \"" ASSUR_BATCH_SCENES
            "/compare.hpp\"\nint main() {\n" +
            calls + "}\n";
  compile(ASSUR_COMPILER,
          std::string(whole ? "-O2" : "-O0") + " -ffp-contract=off -o " + root + "/driver",
          directory.write("driver.cpp", source), directory);
  ASSERT_EQ(std::system((root + "/driver > " + root + "/printed").c_str()), 0);
  std::istringstream printed(read_file(directory.path() / "printed"));
  for (const EmittedScene& scene : scenes) {
    std::string name;
    long verdicts = -1;
    long configurations = 0;
    double largest = 1;
    std::size_t alone = 0;
    printed >> name >> verdicts >> configurations >> largest >> alone;
    std::printf("%s: %ld configurations, largest difference %.1e, %zu solved by themselves\n",
                name.c_str(), configurations, largest, alone);
    EXPECT_EQ(name, scene.solver);
    EXPECT_EQ(verdicts, 0) << name;
    EXPECT_GT(configurations, 0) << name;
    EXPECT_LE(largest, name == "Limited" ? 0 : 1e-6) << name;
  }
}

}  // namespace
}  // namespace assur::test::emit_scene_batch_test
