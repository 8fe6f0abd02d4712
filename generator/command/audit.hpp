// Turns what a user asks of `assur audit` into reports.
#pragma once

#include <string>
#include <vector>

namespace assur::generator::command {

struct AuditOptions {
  std::vector<std::string> files;
  std::string map;  ///< the file that says what the notation of papers in LaTeX stands for
  std::string format = "text";
  bool run = false;     ///< whether programs may be run
  std::string flags;    ///< for their compiler, separated by spaces
  double seconds = 10;  ///< the time limit of a program
};

/// Prints the reports and returns whether everything agrees.
[[nodiscard]] bool run_audit(const AuditOptions& options);

}  // namespace assur::generator::command
