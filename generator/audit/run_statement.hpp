// Reads the rows of a `printed run` statement: a program and how to run it.
#pragma once

#include "audit/running/program_values.hpp"
#include "closures/statement.hpp"

namespace assur::generator::audit {

/// Fewer points than this do not suffice for a verdict.
constexpr std::size_t fewest_points = 3;

struct RunStatement {
  running::UserProgram program;
  closures::PlacedText result;              ///< the expression, and where it stands
  closures::PlacedText position;            ///< the same for the position, if given
  std::vector<closures::PlacedText> where;  ///< formulas that must be positive at the points
  std::size_t points = 40;
  double rounding = 0;  ///< relative error allowed in addition to rounding in double
};

/// `file` is the program's; `rows` are before, position, result, entry, flags, compiler,
/// interpreter, language, where, points, rounding. Throws FormulaError with the place of the error.
[[nodiscard]] RunStatement read_run_statement(const std::filesystem::path& directory,
                                              const closures::PlacedText& file,
                                              const std::vector<closures::PlacedText>& rows);

}  // namespace assur::generator::audit
