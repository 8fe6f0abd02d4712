// Turns the states of a solution into the words that every report uses.
#pragma once

#include <assur/mechanism/report.hpp>
#include <assur/mechanism/reported_parts.hpp>
#include <assur/variables.hpp>
#include <utility>

namespace assur::mechanism::report {

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

/// The reason why there are no configurations; empty if there are some.
[[nodiscard]] inline std::string reason_text(const Report& report) {
  const Solution& solution = report.solution;
  return solution.status == SolutionStatus::no_assembly ? report.plan.obstacle(report.values)
                                                        : solution.reason;
}

/// Why configurations may be missing from the answer; empty where none can be.
[[nodiscard]] inline std::string incomplete_text(const Report& report) {
  return report.alone ? "one configuration alone was sought" : report.solution.incomplete;
}

[[nodiscard]] inline const char* regularity_text(Status regularity) {
  return regularity == Status::ok ? "regular" : "near-singular";
}

/// The wanted results in which the branches through one configuration differ: rates.
[[nodiscard]] inline Want rates_alone(const Want& want) {
  return {false, want.velocity, want.acceleration, false};
}

[[nodiscard]] inline bool is_reported(const Report& report, std::size_t configuration) {
  return report.alone || report.branch == 0 || std::cmp_equal(configuration + 1, report.branch);
}

}  // namespace assur::mechanism::report
