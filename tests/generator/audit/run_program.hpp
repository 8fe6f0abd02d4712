// Audits, by running it, of a program that fills a Jacobian.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "command/command.hpp"

namespace assur::test {

namespace fs = std::filesystem;

/// A slider-crank: J = d(f1, f2)/d(theta, s) is -l sin(theta), -1; l cos(theta), 0.
inline const std::string slider_crank =
    "length r l s\nangle phi theta\nunknown theta s\nmoving phi\n"
    "loop f1 f2 = polar(r, phi) + polar(l, theta) - point(s, 0)\n";

/// A program that fills J, and what the audit answers, and with what status.
struct Program {
  const char* name;
  const char* file;
  const char* text;
  const char* rows;  ///< of the statement; the first names what J is the derivative of
  int status;
  const char* answer;
};

inline void PrintTo(const Program& program, std::ostream* out) { *out << program.name; }

inline bool is_in_octave(const Program& program) {
  return std::string(program.file).ends_with(".m");
}

inline bool is_in_javascript(const Program& program) {
  return std::string(program.file).ends_with("js");
}

/// The programs whose language is installed; configuring says when Octave or Node is not.
inline std::vector<Program> installed(std::vector<Program> programs) {
  if (!ASSUR_OCTAVE) {
    std::erase_if(programs, is_in_octave);
  }
  if (!ASSUR_NODE) {
    std::erase_if(programs, is_in_javascript);
  }
  return programs;
}

/// Octave takes long to start. Programs that never end have a shorter limit.
inline std::string options_of(const Program& program) {
  const bool ends = std::string(program.answer).find("did not end") == std::string::npos;
  const char* const limit = is_in_octave(program) ? (ends ? "8" : "2") : (ends ? "2" : "1");
  return std::string("--run --time-limit ") + limit;
}

inline CommandResult audited(const TemporaryDirectory& directory, const Program& program,
                             const std::string& options) {
  directory.write(program.file, program.text);
  const std::string rows = program.rows;
  const std::size_t end = rows.find('\n');
  const fs::path file =
      directory.write("mine.audit", slider_crank + "printed run J " + program.file + " of " +
                                        rows.substr(0, end) + rows.substr(end) + "\n");
  return run_assur("audit " + file.string() + " " + options);
}

/// Expects the program's status and answer in a folder that may have more files.
inline void expect_answer(const TemporaryDirectory& directory, const Program& program) {
  const CommandResult result = audited(directory, program, options_of(program));
  EXPECT_EQ(result.status, program.status) << result.output << result.messages;
  const std::string& said = program.status == 2 ? result.messages : result.output;
  EXPECT_NE(said.find(program.answer), std::string::npos)
      << "expected: " << program.answer << "\nfound:    " << said;
  if (program.status == 2) {
    EXPECT_EQ(result.output, "");
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
  }
}

inline void expect_judged(const Program& program) { expect_answer(TemporaryDirectory(), program); }

}  // namespace assur::test

#define FRAME "f1 f2 by theta s\n"
#define VECTORS                                                            \
  "#include <cmath>\n#include <vector>\nusing std::sin; using std::cos;\n" \
  "using Rows = std::vector<std::vector<double>>;\n"
#define CALL FRAME "  result f(l, theta)"
#define CPP(body) VECTORS "Rows f(double l, double theta) { " body " }"

#define JAVASCRIPT(body) "const { sin, cos } = Math;\nfunction f(l, theta) { " body " }\n"

#define PYTHON(body) "import math\nfrom math import sin, cos\ndef f(l, theta):\n    " body "\n"
