// Law: `nearest` of an emitted solver returns the configuration and the distances of `assur solve
// --nearest`.
#include <gtest/gtest.h>

#include <cstdio>
#include <sstream>

#include "generator/solver_comparison.hpp"

namespace assur::test::emit_scene_nearest_test {
namespace {

constexpr std::array<double, 6> strokes = {26.5, 30, 34.25, 38, 41, 44.5};

TEST(EmitSceneNearest, IsThatOfSolve) {
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  const std::filesystem::path file = std::filesystem::path(ASSUR_EXAMPLES) / "gripper.json";
  emit_solver({file, "gripper", "Gripper", {}}, directory);
  std::ostringstream program;
  program << "#include <assur/scenes/gripper.hpp>\n#include <cstdio>\nint main() {\n"
          << "  using S = assur::scenes::Gripper;\n"
          << "  std::array<S::State<double>, S::max_configurations> states;\n";
  for (const double stroke : strokes) {
    program << "  {\n    S::Drivers<double> drivers;\n    drivers.piston.position = " << stroke
            << ";\n    const S::Nearest found = S::nearest(S::solve(drivers, states), states);\n"
            << "    std::printf(\"%d %.17g %.17g\\n\", found.configuration, found.distance, "
               "found.runner_up);\n  }\n";
  }
  const auto source = directory.write("driver.cpp", program.str() + "}\n");
  compile_program(source, root + "/driver", directory);
  ASSERT_EQ(std::system((root + "/driver > " + root + "/printed").c_str()), 0);
  std::istringstream printed(read_file(directory.path() / "printed"));
  for (const double stroke : strokes) {
    const CommandResult solved = run_assur("solve " + file.string() + " --nearest --format json" +
                                           " --set stroke=" + std::to_string(stroke));
    const auto nearest = nlohmann::json::parse(solved.output)["nearest"];
    int configuration = 0;
    double distance = 0;
    double runner_up = 0;
    printed >> configuration >> distance >> runner_up;
    EXPECT_EQ(configuration + 1, nearest["configuration"].get<int>()) << stroke;
    EXPECT_NEAR(distance, nearest["distance"].get<double>(), 1e-12) << stroke;
    EXPECT_NEAR(runner_up, nearest["runner_up"].get<double>(), 1e-12) << stroke;
  }
}

}  // namespace
}  // namespace assur::test::emit_scene_nearest_test
