// Comparison of emitted solvers, run in one program, with `assur solve`.
#pragma once

#include <cctype>
#include <cstdlib>

#include "generator/solve_readings.hpp"
#include "whole_campaign.hpp"

namespace assur::test {

/// The largest difference of numbers, relative to the largest of their sort in the configuration.
inline constexpr double agreement = 1e-12;

inline const std::string warnings_as_errors = " -Wall -Wextra -Wconversion -Wshadow -Werror ";

/// The solver's struct by the stem of its file: `four_bar` as `FourBar`.
inline std::string struct_of(const std::string& stem) {
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

/// Emits the solver below a directory.
inline void emit_solver(const EmittedScene& scene, const TemporaryDirectory& directory,
                        const std::string& options = "") {
  const CommandResult emitted = run_assur("emit --scene '" + scene.file.string() + "' --output " +
                                          directory.path().string() + " " + options);
  ASSERT_EQ(emitted.status, 0) << emitted.messages;
}

/// Runs a compiler over a file of C++17 that includes solvers from the directory. Numbers
/// that a solver leaves unset are NaN.
inline void compile(const std::string& compiler, const std::string& options,
                    const std::filesystem::path& source, const TemporaryDirectory& directory) {
  const std::string root = directory.path().string();
  const std::string line = compiler + " " ASSUR_SOLVER_FLAGS + warnings_as_errors + options +
                           " -I" + root + " " + source.string() + " 2> " + root + "/errors";
  ASSERT_EQ(std::system(line.c_str()), 0)
      << compiler << ": " << read_file(directory.path() / "errors").substr(0, 4000);
}

/// A compiler with its options and libraries.
struct SolverCompiler {
  std::string command;
  std::string objects = {};
};

/// By default this is clang++, if there is one, with the headers that solvers share compiled
/// before: it takes a third of the time. Whole campaigns use the compiler of the project.
inline SolverCompiler quick_compiler() {
  const std::string clang = ASSUR_CLANG;
  return clang.empty() || is_whole_campaign()
             ? SolverCompiler{ASSUR_COMPILER}
             : SolverCompiler{clang + " -include-pch " ASSUR_SOLVER_HEADERS ".pch",
                              ASSUR_SOLVER_LINKER ASSUR_SOLVER_HEADERS ".o "};
}

/// Compiles a file to a program.
inline void compile_program(const std::filesystem::path& source, const std::string& program,
                            const TemporaryDirectory& directory,
                            const SolverCompiler& compiler = quick_compiler()) {
  compile(compiler.command, "-O0 " + compiler.objects + "-o " + program, source, directory);
}

/// Checks a file with clang++, too, if there is one: a short one always, others in whole campaigns.
inline void check_by_clang(const std::filesystem::path& source, const TemporaryDirectory& directory,
                           bool is_short = false) {
  const bool asked = is_short || is_whole_campaign();
  if (const std::string clang = ASSUR_CLANG; !clang.empty() && asked) {
    compile(clang, "-fsyntax-only", source, directory);
  }
}

/// The entry of a parameter; infinity where it is not modelled.
inline constexpr const char* program_head = R"(#include <cstdio>
#include <cstring>
#include <limits>
template <typename Solver, typename Matrix>
double sensitivity(const Matrix& matrix, const char* parameter, int row) {
  for (int column = 0; column < Solver::parameter_count; ++column) {
    if (std::strcmp(Solver::parameters[static_cast<std::size_t>(column)], parameter) == 0) {
      return matrix(row, column);
    }
  }
  return std::numeric_limits<double>::infinity();
}
)";

/// Prints, for each step, the number of configurations and then every reading of each. A solver
/// with variable parameters gets the given values.
inline std::string printing_function(const EmittedScene& scene, const SolveReadings& expected,
                                     const std::string& name,
                                     const std::map<std::string, double>& parameters = {}) {
  std::ostringstream code;
  code.precision(17);
  code << "template <typename S>\nvoid " << name
       << "_state(const typename S::template State<double>& s) {\n";
  const auto listed = std::find_if(expected.begin(), expected.end(),
                                   [](const auto& step) { return !step.empty(); });
  if (listed != expected.end()) {
    for (const Reading& reading : listed->front()) {
      code << "  std::printf(\"%.17g\\n\", " << reading.code << ");\n";
    }
  }
  code << "  (void)s;\n}\nvoid " << name << "() {\n  using S = assur::scenes::" << scene.solver
       << ";\n  std::array<S::State<double>, S::max_configurations> states;\n";
  const auto drivers = scene_json(scene.file).value("drivers", nlohmann::ordered_json::object());
  for (const double step : driver_steps) {
    code << "  {\n    S::Drivers<double> drivers;\n";
    for (const auto& [joint, driver] : drivers.items()) {
      if (is_argument(driver)) {
        code << "    drivers." << scene.member(joint) << ".position += " << step << ";\n";
      }
    }
    if (!parameters.empty()) {
      code << "    S::Parameters<double> parameters;\n";
    }
    for (const auto& [parameter, value] : parameters) {
      code << "    parameters." << parameter << " = " << value << ";\n";
    }
    code << "    const S::Solution found = S::solve(drivers, "
         << (parameters.empty() ? "" : "parameters, ") << "states);\n"
         << "    std::printf(\"%d\\n\", found.count);\n"
         << "    for (int i = 0; i < found.count; ++i) {\n      " << name
         << "_state<S>(states[static_cast<std::size_t>(i)]);\n    }\n  }\n";
  }
  code << "}\n";
  return code.str();
}

/// Compares the program's output for a scene; returns the number of comparisons.
inline int compare_printed(std::istream& printed, const EmittedScene& scene,
                           const SolveReadings& expected) {
  double largest = 0;
  int compared = 0;
  for (std::size_t step = 0; step < expected.size(); ++step) {
    std::size_t count = 0;
    printed >> count;
    EXPECT_EQ(count, expected[step].size()) << scene.solver << " at step " << driver_steps[step];
    if (count != expected[step].size()) {
      return 0;
    }
    for (const std::vector<Reading>& configuration : expected[step]) {
      std::map<std::string, double> sizes;
      for (const Reading& reading : configuration) {
        double& size = sizes[reading.sort];
        size = std::max(size, std::abs(reading.value));
      }
      for (const Reading& reading : configuration) {
        std::string text;
        printed >> text;
        const double value = std::strtod(text.c_str(), nullptr);
        if (std::isinf(value) && reading.sort.starts_with("sensitivity")) {
          continue;  // the scene has tolerances, and this parameter has none
        }
        const double size = sizes[reading.sort];
        const double error = std::abs(value - reading.value) / (size > 0 ? size : 1);
        EXPECT_LE(error, agreement) << scene.solver << " at step " << driver_steps[step] << ": "
                                    << reading.code << " " << value << " " << reading.value;
        largest = std::max(largest, error);
        ++compared;
      }
    }
  }
  std::printf("%s: largest relative difference %.1e over %d numbers\n", scene.solver.c_str(),
              largest, compared);
  return compared;
}

/// Expects that every number of every scene agrees; returns the numbers of comparisons.
inline std::vector<int> compare_with_solve(const std::vector<EmittedScene>& scenes,
                                           const SolverCompiler& compiler = quick_compiler()) {
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  std::string includes;
  std::string functions;
  std::string calls;
  std::vector<SolveReadings> expected;
  for (const EmittedScene& scene : scenes) {
    emit_solver(scene, directory);
    expected.push_back(solve_readings(scene));
    const std::string name = "print_" + std::to_string(expected.size());
    includes += "#include <assur/scenes/" + scene.header + ".hpp>\n";
    functions += printing_function(scene, expected.back(), name);
    calls += "  " + name + "();\n";
  }
  const auto source = directory.write(
      "driver.cpp", includes + program_head + functions + "int main() {\n" + calls + "}\n");
  check_by_clang(directory.write("headers.cpp", includes), directory);
  compile_program(source, root + "/driver", directory, compiler);
  if (testing::Test::HasFailure() ||
      std::system((root + "/driver > " + root + "/printed").c_str()) != 0) {
    ADD_FAILURE() << "no program to compare";
    return std::vector<int>(scenes.size());
  }
  std::istringstream printed(read_file(directory.path() / "printed"));
  std::vector<int> compared;
  for (std::size_t index = 0; index < scenes.size(); ++index) {
    compared.push_back(compare_printed(printed, scenes[index], expected[index]));
  }
  return compared;
}

}  // namespace assur::test
