// Law: a solver's C header compiles as C99 and C++, alone and beside another one, whatever the
// scene's names are; it has what the scene wants, and the C++ header does not depend on it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <vector>

#include "command/command.hpp"

namespace assur::test::c_header_test {
namespace {

namespace fs = std::filesystem;

/// A four-bar whose parts are named like C keywords and macros, with trigraphs; it wants `wanted`.
std::string awkward_four_bar(const std::string& wanted) {
  return R"({"name": "odd ??/ \\",
  "parameters": {"restrict": 2, "solve": 5, "I": {"value": 1, "tolerance": 0.1}},
  "links": {
    "ground": {"A": [0, 0], "D": ["solve", 0]}, "restrict": {"A": [0, 0], "B": ["restrict", 0]},
    "typeof??/": {"B": [0, 0], "C": ["5*I", 0], "P": [1, 1]}, "class": {"D": [0, 0], "C": [2, 0]}},
  "joints": {
    "near": {"type": "revolute", "between": ["ground.A", "restrict.A"]},
    "B": {"type": "revolute", "between": ["restrict.B", "typeof??/.B"]},
    "C": {"type": "revolute", "between": ["typeof??/.C", "class.C"]},
    "D": {"type": "revolute", "between": ["ground.D", "class.D"]}},
  "drivers": {"near": {"position": 0.7}},
  "outputs": {"inline": "typeof??/.P", "double": "typeof??/.C"}, "want": [)" +
         wanted + "]}";
}

CommandResult emit(const fs::path& scene, const TemporaryDirectory& directory,
                   const std::string& options) {
  return run_assur("emit --scene '" + scene.string() + "' --output " + directory.path().string() +
                   " " + options);
}

void check_syntax(const std::string& language, const std::string& text,
                  const TemporaryDirectory& directory) {
  const std::string errors = (directory.path() / "errors").string();
  const std::string line = ASSUR_COMPILER " " + language +
                           " -Wall -Wextra -Wconversion -Werror -pedantic -fsyntax-only -I" +
                           directory.path().string() + " " +
                           directory.write("reads.txt", text).string() + " 2> " + errors;
  EXPECT_EQ(std::system(line.c_str()), 0) << language << "\n" << read_file(errors);
}

TEST(CHeader, IsC99AndCppWithAnyNames) {
  const TemporaryDirectory directory;
  const fs::path all = directory.write(
      "2-I.json", awkward_four_bar(R"("position", "velocity", "acceleration", "sensitivity")"));
  const fs::path one = directory.write("class.json", awkward_four_bar(R"("position")"));
  ASSERT_EQ(emit(one, directory, "").status, 0);
  const std::string without = read_file(directory.path() / "assur/scenes/class.hpp");
  EXPECT_FALSE(fs::exists(directory.path() / "assur/scenes/class.h"));
  const std::string in_c = "--interface c";
  EXPECT_EQ(emit(one, directory, in_c + " --check").status, 1);
  ASSERT_EQ(emit(one, directory, in_c).status, 0);
  EXPECT_EQ(emit(one, directory, in_c + " --check").status, 0);
  ASSERT_EQ(emit(all, directory, in_c + " --variable all").status, 0);
  EXPECT_EQ(read_file(directory.path() / "assur/scenes/class.hpp"), without);
  const std::string includes =
      "#define min(a, b) ((a) < (b) ? (a) : (b))\n#define near\n#define far\n"
      "#include <assur/scenes/_2_I.h>\n#include <assur/scenes/class.h>\n"
      "#include <assur/scenes/_2_I.h>\n"
      "class_status call(class_solution* found, class_drivers* drivers) {\n"
      "  class_defaults(drivers);\n  return class_solve(drivers, found);\n}\n"
      "int column(void) { return n2_I_column_I_2 + n2_I_parameter_count; }\n";
  check_syntax("-x c -std=c99", "#include <complex.h>\n" + includes, directory);
  check_syntax("-x c++ -std=c++17", includes, directory);
  const std::string header = read_file(directory.path() / "assur/scenes/class.h");
  EXPECT_EQ(header.find("velocity"), std::string::npos);
  EXPECT_EQ(header.find("sensitivity"), std::string::npos);
}

/// A structure, of which nothing moves, with a long name; or a crank alone. It wants positions.
std::string still_scene(const std::string& name, const std::string& outputs, bool has_group) {
  const std::string links =
      has_group ? R"("p": {"A": [0, 0], "C": [2, 0]}, "q": {"B": [0, 0], "C": [2.5, 0]})"
                : R"("p": {"A": [0, 0], "C": [2, 0]})";
  const std::string joints = has_group
                                 ? R"(, "B": {"type": "revolute", "between": ["ground.B", "q.B"]},
                                        "C": {"type": "revolute", "between": ["p.C", "q.C"]})"
                                 : "";
  return R"({"name": ")" + name + R"(", "links": {"ground": {"A": [0, 0], "B": [3, 1]}, )" + links +
         R"(}, "joints": {"A": {"type": "revolute", "between": ["ground.A", "p.A"]})" + joints +
         "}, " + (has_group ? "" : R"("drivers": {"A": {"position": 1}}, )") + R"("outputs": {)" +
         outputs + R"(}, "want": ["position"]})";
}

/// Compiles a solver's files, both, as users do: optimised and with warnings.
void compile_both(const std::string& stem, const TemporaryDirectory& directory) {
  check_syntax("-x c -std=c99", "#include <assur/scenes/" + stem + ".h>\n", directory);
  for (const std::string compiler : {ASSUR_COMPILER, ASSUR_CLANG}) {
    const std::string errors = (directory.path() / "errors").string();
    const std::string root = directory.path().string();
    const std::string line = compiler +
                             " -std=c++17 -O2 -Wall -Wextra -Wconversion -Wshadow -Werror "
                             "-I" ASSUR_RUNTIME " -isystem " ASSUR_EIGEN " -I" +
                             root + " -c " + root + "/assur/scenes/" + stem + ".cpp -o " + root +
                             "/object.o 2> " + errors;
    if (!compiler.empty()) {
      EXPECT_EQ(std::system(line.c_str()), 0) << compiler << "\n" << read_file(errors);
    }
  }
}

TEST(CHeader, OfStructuresWithLongNamesCompilesOptimised) {
  const TemporaryDirectory directory;
  const std::string stem(80, 'n');
  const fs::path scene = directory.write(
      stem + ".json", still_scene(std::string(300, 'x') + " y", R"("C": "p.C")", true));
  ASSERT_EQ(emit(scene, directory, "--interface c").status, 0);
  compile_both(stem, directory);
  for (const std::string ending : {".h", ".cpp", ".hpp"}) {
    std::istringstream lines(read_file(directory.path() / "assur/scenes" / (stem + ending)));
    for (std::string line; std::getline(lines, line);) {
      EXPECT_FALSE(line == "#ifndef" || line == "#define" || line == "#include") << ending;
    }
  }
}

/// Lines are broken at spaces, wherever names of some length put these.
TEST(CHeader, BreaksNoTextOrDirectiveWithNamesOfAnyLength) {
  const TemporaryDirectory directory;
  for (std::size_t length = 1; length <= 90; length += 7) {
    const std::string stem(length, 'n');
    const fs::path scene = directory.write(stem + ".json", awkward_four_bar(R"("position")"));
    ASSERT_EQ(emit(scene, directory, "--interface c --variable all").status, 0);
    for (const std::string ending : {".h", ".cpp", ".hpp"}) {
      std::istringstream lines(read_file(directory.path() / "assur/scenes" / (stem + ending)));
      for (std::string line; std::getline(lines, line);) {
        const bool is_comment = line.find("//") != std::string::npos ||
                                line.find("* ") != std::string::npos ||
                                line.find("/*") != std::string::npos;
        EXPECT_TRUE(is_comment || std::ranges::count(line, '"') % 2 == 0) << ending << ": " << line;
        EXPECT_FALSE(line == "#ifndef" || line == "#define" || line == "#include") << ending;
      }
    }
  }
}

/// A slider-crank with crank and rod of one length, in steps that end on its change points: the
/// piston goes on along 2 cos or stays at zero.
TEST(CHeader, TracksGoOverChangePoints) {
  const TemporaryDirectory directory;
  const fs::path scene = directory.write("slider_of_equal_lengths.json", R"({
  "links": {"ground": {"A": [0, 0], "g": {"through": [0, 0], "along": [1, 0]}},
    "crank": {"A": [0, 0], "B": [1, 0]}, "rod": {"B": [0, 0], "C": [1, 0]},
    "piston": {"C": [0, 0], "g": {"through": [0, 0], "along": [1, 0]}}},
  "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
    "B": {"type": "revolute", "between": ["crank.B", "rod.B"]},
    "C": {"type": "revolute", "between": ["rod.C", "piston.C"]},
    "S": {"type": "prismatic", "between": ["ground.g", "piston.g"]}},
  "drivers": {"A": {"position": 0.7}}, "outputs": {"C": "piston.C"}, "want": ["position"]})");
  ASSERT_EQ(emit(scene, directory, "--interface c").status, 0);
  const std::string root = directory.path().string();
  const auto program =
      directory.write("tracks.c", R"(#include <assur/scenes/slider_of_equal_lengths.h>
#include <math.h>
#include <stdio.h>
int main(void) {
  double off = 0;
  int configuration;
  int step;
  for (configuration = 0; configuration < 2; ++configuration) {
    slider_of_equal_lengths_drivers drivers;
    slider_of_equal_lengths_branch branch;
    slider_of_equal_lengths_state state;
    slider_of_equal_lengths_way way;
    int stays = 0;
    slider_of_equal_lengths_defaults(&drivers);
    drivers.A.position = 0;
    slider_of_equal_lengths_begin(&drivers, configuration, &branch);
    for (step = 1; step <= 72; ++step) {
      double at = 0;
      double away = 0;
      drivers.A.position = step * 3.141592653589793 / 18;
      slider_of_equal_lengths_track(&drivers, &branch, &state, &way);
      if (way.reached < 1) {
        printf("stops at step %d\n", step);
        return 1;
      }
      at = state.outputs.C.position[0];
      away = fabs(at - 2 * cos(drivers.A.position));
      stays = step == 1 ? fabs(at) < away : stays;
      off = fmax(off, stays ? fabs(at) : away);
    }
  }
  printf("off by %.1e at most\n", off);
  return off < 1e-9 ? 0 : 1;
}
)");
  const std::string errors = root + "/errors";
  const std::string line =
      ASSUR_COMPILER " -std=c++17 -O0 -I" ASSUR_RUNTIME " -isystem " ASSUR_EIGEN " -I" + root +
      " -c " + root + "/assur/scenes/slider_of_equal_lengths.cpp -o " + root + "/solver.o 2> " +
      errors + " && " ASSUR_COMPILER " -x c -std=c99 -Wall -Werror -I" + root + " -c " +
      program.string() + " -o " + root + "/tracks.o 2>> " + errors + " && " ASSUR_COMPILER " " +
      root + "/tracks.o " + root + "/solver.o -lm -o " + root + "/tracks 2>> " + errors + " && " +
      root + "/tracks";
  EXPECT_EQ(std::system(line.c_str()), 0) << read_file(errors);
}

TEST(LongCHeader, OfScenesOfWhichLittleIsWantedCompilesOptimised) {
  const TemporaryDirectory directory;
  const std::vector<std::pair<std::string, std::string>> scenes = {
      {"namespace", still_scene("1 2", "", true)},
      {"1_digit", still_scene("int", R"("C": "p.C")", false)},
      {"nothing", still_scene("class", "", false)}};
  for (const auto& [stem, text] : scenes) {
    const fs::path scene = directory.write(stem + ".json", text);
    ASSERT_EQ(emit(scene, directory, "--interface c").status, 0);
    compile_both(fs::exists(directory.path() / ("assur/scenes/" + stem + ".h")) ? stem : "_" + stem,
                 directory);
  }
}

TEST(CHeader, IsAskedForOfScenesAlone) {
  const TemporaryDirectory directory;
  const std::string output = " --output " + directory.path().string();
  EXPECT_EQ(run_assur("emit --model 1 --interface c" + output).status, 2);
  EXPECT_EQ(run_assur("emit --scene x.json --interface fortran" + output).status, 2);
  EXPECT_TRUE(fs::is_empty(directory.path()));
}

}  // namespace
}  // namespace assur::test::c_header_test
