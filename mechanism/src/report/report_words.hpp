// Words for the states of a solution, common to all reports.
#pragma once

#include <assur/mechanism/report.hpp>
#include <assur/mechanism/reported_parts.hpp>
#include <assur/variables.hpp>
#include <optional>
#include <utility>
#include <vector>

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

/// Why configurations may be missing from the answer; empty if none can be.
[[nodiscard]] inline std::string incomplete_text(const Report& report) {
  return report.alone ? "one configuration alone was sought" : report.solution.incomplete;
}

/// The configuration nearest to the limits of joints, if all are beyond them.
[[nodiscard]] inline std::optional<NearestToLimits> nearest_to_limits(const Report& report) {
  const Solution& solution = report.solution;
  return solution.status == SolutionStatus::no_assembly && solution.left_out.value_or(0) > 0
             ? report.plan.nearest_to_limits(report.values)
             : std::nullopt;
}

[[nodiscard]] inline const char* regularity_text(Status regularity) {
  return regularity == Status::ok ? "regular" : "near-singular";
}

/// The place of a configuration in the sweep: its branch and its circuit, 0 if unknown.
struct PlaceInSweep {
  int branch, circuit;
};
/// The place of a configuration of the solution; nothing if it was not requested.
[[nodiscard]] inline std::optional<PlaceInSweep> place_in_sweep(const Report& report,
                                                                std::size_t configuration) {
  if (!report.places) {
    return std::nullopt;
  }
  const std::vector<int>& branches = report.places->branches;
  const int branch = configuration < branches.size() ? branches[configuration] : 0;
  return PlaceInSweep{branch, report.places->circuits.of(branch)};
}

/// The requested results in which the branches through one configuration differ: rates.
[[nodiscard]] inline Want rates_alone(const Want& want) {
  return {false, want.velocity, want.acceleration, false};
}

[[nodiscard]] inline bool is_reported(const Report& report, std::size_t configuration) {
  return report.alone || report.branch == 0 || std::cmp_equal(configuration + 1, report.branch);
}

}  // namespace assur::mechanism::report
