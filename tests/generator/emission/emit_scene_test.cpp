// Law: the solver emitted for a scene agrees with `assur solve`, whatever the links, joints,
// outputs and the file of the scene are called.
#include <gtest/gtest.h>

#include <numeric>

#include "generator/awkward_scene.hpp"
#include "generator/scene_files.hpp"
#include "generator/solver_comparison.hpp"
#include "whole_campaign.hpp"

namespace assur::test::emit_scene_test {
namespace {

namespace fs = std::filesystem;

/// Every `stride`-th example.
std::vector<EmittedScene> examples(std::size_t stride) {
  std::vector<EmittedScene> scenes;
  std::size_t number = 0;
  for (const fs::path& file : scene_files({ASSUR_EXAMPLES, ASSUR_SCENES})) {
    if (number++ % stride != 0) {
      continue;
    }
    const std::string stem = file.stem().string();
    scenes.push_back({file, stem, struct_of(stem), {}});
  }
  return scenes;
}

/// A scene whose names have to change to become identifiers.
EmittedScene awkwardly_named(const TemporaryDirectory& directory) {
  const std::map<std::string, std::string> members = {
      {"class", "class_2"},     {"1-2", "n1_2"},   {"1 2", "n1_2_2"},
      {"slide_S", "slide_S_2"}, {"\u00e9\n", "n"}, {"__Drivers", "Drivers_2"}};
  return {directory.write("4-bar & \"co\".json", awkward_scene().dump()), "_4_bar_co",
          "Scene4BarCo", members};
}

/// All scenes in one program, because they share most of its compilation; by default every sixth
/// example. The project's compiler compiles it.
TEST(EmitScene, AgreesWithSolveOverAllExamplesAndAwkwardNames) {
  const TemporaryDirectory directory;
  const bool whole = is_whole_campaign();
  std::vector<EmittedScene> scenes = examples(whole ? 1 : 6);
  scenes.push_back(awkwardly_named(directory));
  const std::vector<int> compared = compare_with_solve(scenes, {ASSUR_COMPILER});
  for (std::size_t index = 0; index < scenes.size(); ++index) {
    EXPECT_GT(compared[index], 100) << scenes[index].solver;
  }
  const int all = std::accumulate(compared.begin(), compared.end(), 0);
  std::printf("all: %d numbers\n", all);
  EXPECT_GT(all, whole ? 10000 : 1000);
}

}  // namespace
}  // namespace assur::test::emit_scene_test
