// Prints a straight-line program as lines of C++.
#pragma once

#include <functional>
#include <set>
#include <string>

#include "emission/cpp/filled_lines.hpp"
#include "program/program.hpp"

namespace assur::generator::emission::cpp {

/// The C++ spelling of a symbol that a program reads: `q.theta_BCG.cos`.
using Spelling = std::function<std::string(const std::string& symbol)>;

/// The shortest decimal number that is read as the same double; zero has no sign.
[[nodiscard]] std::string round_trip(double value);

/// The rational number equal to a double.
[[nodiscard]] GiNaC::numeric exact(double value);
/// Whether some double equals a rational number exactly.
[[nodiscard]] bool is_double(const GiNaC::numeric& number);

/// Adds the program's statements: its steps, which are declarations, and its assignments.
void add_program(const program::Program& program, const Spelling& spelling, FilledLines& lines);
void add_steps(const program::Program& program, const Spelling& spelling, FilledLines& lines);
void add_assignments(const program::Program& program, const Spelling& spelling, FilledLines& lines);

/// The named constants that these statements read.
[[nodiscard]] std::set<std::string> constants_of(const program::Program& program);

/// The text with every line over 100 columns broken, code after commas and before operators.
[[nodiscard]] std::string fitted_to_width(const std::string& text);

}  // namespace assur::generator::emission::cpp
