// Turns what a user asks of `assur audit` into reports.
#pragma once

#include <string>
#include <vector>

namespace assur::generator::command {

struct AuditOptions {
  std::vector<std::string> files;
  std::string map;  ///< of papers in LaTeX: what their notation stands for
  std::string format = "text";
  bool run = false;   ///< may programs be run?
  std::string flags;  ///< for their compiler, between spaces
  double seconds = 10;
};

/// Prints the reports; whether all agrees.
[[nodiscard]] bool run_audit(const AuditOptions& options);

}  // namespace assur::generator::command
