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
  bool draft = false;   ///< the files are programs or papers, and their audit files are wanted
  std::string output;   ///< the file of a draft; standard output where it is empty
  bool force = false;   ///< whether that file may be replaced
};

/// Prints the reports and returns whether everything agrees.
[[nodiscard]] bool run_audit(const AuditOptions& options);

/// Writes the audit file for a program, or the map for a paper, as far as it can be told.
void draft_audit(const AuditOptions& options);

}  // namespace assur::generator::command
