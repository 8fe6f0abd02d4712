// One program of the emitted solvers of several scenes, and its output for every state.
#pragma once

#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "generator/solver_comparison.hpp"
#include "mechanism/scene_solutions.hpp"

namespace assur::test {

/// A scene and its name, which is also that of its solver's files.
struct NamedScene {
  std::string name;
  nlohmann::ordered_json json;
};

/// C++ that prints a number, `inf` and `nan` included.
inline std::string printing(const std::string& number) {
  return "  std::printf(\"%.17g\\n\", static_cast<double>(" + number + "));\n";
}

inline double read_number(std::istream& printed) {
  std::string text;
  printed >> text;
  return std::strtod(text.c_str(), nullptr);
}

/// Emits a solver for each scene, and runs all in one program: it prints the number of
/// configurations of each scene, and the output of `code_of(scene)` for every state `s`. The
/// solvers' struct is `S`, and `head` is in front of the functions. Each scene ends with `end`.
inline std::istringstream printed_states(const std::vector<NamedScene>& scenes,
                                         const std::function<std::string(const Solved&)>& code_of,
                                         const std::string& scalar = "double",
                                         const std::string& head = "") {
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  std::string includes = "#include <cstdio>\n";
  std::string functions;
  std::string calls;
  for (const NamedScene& scene : scenes) {
    const EmittedScene emitted = {directory.write(scene.name + ".json", scene.json.dump()),
                                  scene.name,
                                  struct_of(scene.name),
                                  {}};
    emit_solver(emitted, directory);
    includes += "#include <assur/scenes/" + scene.name + ".hpp>\n";
    functions +=
        "void " + scene.name + "() {\n  using S = assur::scenes::" + emitted.solver +
        ";\n  static std::array<S::State<" + scalar +
        ">, S::max_configurations> states;\n  const S::Solution found = S::solve(S::Drivers<" +
        scalar + ">{}, states);\n  std::printf(\"%d\\n\", found.count);\n" +
        "  for (int i = 0; i < found.count; ++i) {\n  const auto& s = " +
        "states[static_cast<std::size_t>(i)];\n" + code_of(solved(scene.json)) +
        "  }\n  std::puts(\"end\");\n}\n";
    calls += "  " + scene.name + "();\n";
  }
  const auto source =
      directory.write("driver.cpp", includes + head + functions + "int main() {\n" + calls + "}\n");
  compile_program(source, root + "/driver", directory);
  if (testing::Test::HasFailure() ||
      std::system((root + "/driver > " + root + "/printed").c_str()) != 0) {
    ADD_FAILURE() << "no program to compare";
    return {};
  }
  return std::istringstream(read_file(directory.path() / "printed"));
}

/// Calls `compare` for every configuration of every scene, to read its printed numbers. A scene
/// whose list may be incomplete is left out if the solver lists another number of configurations.
inline void for_each_printed(
    const std::vector<NamedScene>& scenes, std::istringstream printed,
    const std::function<void(const Solved&, const Configuration&, std::istream&)>& compare) {
  for (const NamedScene& scene : scenes) {
    SCOPED_TRACE(scene.name);
    const Solved known = solved(scene.json);
    std::size_t count = 0;
    printed >> count;
    const bool are_as_many = count == known.configurations().size();
    EXPECT_TRUE(are_as_many || !known.solution.incomplete.empty()) << count;
    for (const Configuration& configuration : known.configurations()) {
      if (are_as_many) {
        compare(known, configuration, printed);
      }
    }
    std::string word;
    while (printed >> word && word != "end") {
      EXPECT_FALSE(are_as_many) << "more is printed than read";
    }
  }
}

}  // namespace assur::test
