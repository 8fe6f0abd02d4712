// Turns a user's program and points into what the program computes there.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace assur::generator::audit::running {

enum class Language : unsigned char { cpp, c, python, octave };

/// A function in a file, and how to call it for a matrix. Quantities are variables of their names.
struct UserProgram {
  std::filesystem::path file;       ///< absolute
  std::filesystem::path directory;  ///< in which it is compiled: paths in flags start there
  Language language = Language::cpp;
  std::vector<std::string> before;  ///< statements that run before, in its own language
  std::string result;               ///< an expression: the matrix
  std::string entry;                ///< in `result`, `i` and `j`; empty: by the result's type
  std::vector<std::string> flags;   ///< of the compiler or the interpreter
  std::string tool;                 ///< which one; empty: the usual one of the language
};

struct MatrixSize {
  std::size_t rows = 0;
  std::size_t columns = 0;
};

/// Quantities by name, and their values at each point.
struct PointTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> points;
};

struct RunLimits {
  double seconds = 10;                ///< for a run; compilation may take six times as long
  std::size_t megabytes = 2048;       ///< of memory for a compiled program
  std::size_t most_megabytes = 8192;  ///< for compilers and interpreters
};

/// Why a program did not give its values, in one line; `point` is the first point without values.
struct ProgramError : std::runtime_error {
  explicit ProgramError(const std::string& what, std::size_t at = none)
      : std::runtime_error(what), point(at) {}
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t point;
};

/// The entries for each point, row by row, all finite. Throws ProgramError.
[[nodiscard]] std::vector<std::vector<double>> program_values(const UserProgram& program,
                                                              const MatrixSize& size,
                                                              const PointTable& table,
                                                              const RunLimits& limits);

}  // namespace assur::generator::audit::running
