// Turns the states of a solution into the words that every report uses.
#pragma once

#include <assur/mechanism/report.hpp>
#include <assur/variables.hpp>

namespace assur::mechanism {

[[nodiscard]] inline const char* status_text(SolutionStatus status) {
  switch (status) {
    case SolutionStatus::ok:
      return "ok";
    case SolutionStatus::no_assembly:
      return "no-assembly";
    case SolutionStatus::degenerate:
      return "degenerate";
  }
  return "unknown";
}

/// Why there are no configurations; nothing if there are.
[[nodiscard]] inline std::string reason_text(const Report& report) {
  const Solution& solution = report.solution;
  return solution.status == SolutionStatus::no_assembly ? report.plan.obstacle(report.values)
                                                        : solution.reason;
}

[[nodiscard]] inline const char* regularity_text(Status regularity) {
  return regularity == Status::ok ? "regular" : "near-singular";
}

[[nodiscard]] inline bool is_reported(const Report& report, std::size_t configuration) {
  return report.branch == 0 || configuration + 1 == static_cast<std::size_t>(report.branch);
}

}  // namespace assur::mechanism
