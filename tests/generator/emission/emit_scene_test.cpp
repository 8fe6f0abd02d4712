// Law: the solver emitted for a scene agrees with `assur solve`.
#include <gtest/gtest.h>

#include "solver_comparison.hpp"

namespace assur::test::emit_scene_test {
namespace {

namespace fs = std::filesystem;

/// `four_bar` as `FourBar`.
std::string struct_of(const std::string& stem) {
  std::string name;
  bool capital = true;
  for (const char c : stem) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (plain) {
      name += static_cast<char>(capital ? std::toupper(c) : c);
    }
    capital = !plain;
  }
  return name;
}

std::vector<EmittedScene> examples() {
  std::vector<fs::path> files;
  for (const char* directory : {ASSUR_EXAMPLES, ASSUR_SCENES}) {
    for (const auto& entry : fs::directory_iterator(directory)) {
      if (entry.path().extension() == ".json") {
        files.push_back(entry.path());
      }
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<EmittedScene> scenes;
  for (const fs::path& file : files) {
    const std::string stem = file.stem().string();
    scenes.push_back({file, stem, struct_of(stem), {}});
  }
  return scenes;
}

TEST(EmitScene, AgreesWithSolveOverAllExamples) {
  const int compared = compare_with_solve(examples());
  std::printf("all: %d numbers\n", compared);
  EXPECT_GT(compared, 10000);
}

}  // namespace
}  // namespace assur::test::emit_scene_test
