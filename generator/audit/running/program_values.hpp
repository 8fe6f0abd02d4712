// The values that a user's program computes at points.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace assur::generator::audit::running {

enum class Language : unsigned char { cpp, c, python, octave, javascript };

/// A function in a file, and how to call it for a matrix. Quantities are variables of their names.
struct UserProgram {
  std::filesystem::path file;       ///< absolute
  std::filesystem::path directory;  ///< directory of compilation: paths in flags start there
  Language language = Language::cpp;
  std::vector<std::string> before;  ///< statements to run first, in the program's language
  std::string result;               ///< an expression: the matrix
  std::string entry;                ///< in `result`, `i` and `j`; empty: by the result's type
  std::vector<std::string> flags;   ///< of the compiler or the interpreter
  std::string tool;                 ///< its name; empty: the usual one of the language
};

struct MatrixSize {
  std::size_t rows = 0;
  std::size_t columns = 0;
};

/// Quantities by name, and their values at each point.
struct PointTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> points;
  std::vector<std::vector<double>> imaginary{};  ///< of the values; empty where all are real
};

struct RunLimits {
  double seconds = 10;                ///< per run; compilation may take six times as long
  std::size_t megabytes = 2048;       ///< of memory for a compiled program
  std::size_t most_megabytes = 8192;  ///< for compilers and interpreters
};

/// The reason why a program cannot be run at all, in one line.
struct ProgramError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The values of a program at one point, row by row.
struct PointValues {
  std::vector<double> entries;
  std::vector<double> imaginary;    ///< of the entries, if the quantities have imaginary parts
  std::vector<std::string> faults;  ///< why an entry has no value; else empty
};

struct ProgramValues {
  /// Values up to the point at which the program crashed or did not end.
  std::vector<PointValues> points;
  bool single_precision = false;  ///< of the result, or of parameters declared in the file
};

/// Whether functions of a language that are written for real numbers take complex ones.
[[nodiscard]] bool takes_complex_numbers(Language language);

/// Runs the program at all points. Throws ProgramError.
[[nodiscard]] ProgramValues program_values(const UserProgram& program, const MatrixSize& size,
                                           const PointTable& table, const RunLimits& limits);

}  // namespace assur::generator::audit::running
