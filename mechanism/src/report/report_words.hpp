// Turns the states of a solution into the words that every report uses.
#pragma once

#include <algorithm>
#include <assur/mechanism/report.hpp>
#include <assur/variables.hpp>
#include <limits>

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

/// A configuration without the derivatives that are not known.
[[nodiscard]] inline Configuration without_derivatives(const Plan& plan,
                                                       Configuration configuration) {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  const auto forget = [unknown](auto& item) {
    item.velocity *= unknown;
    item.acceleration *= unknown;
    item.follows.first *= unknown;
    for (auto& second : item.follows.second) {
      second *= unknown;
    }
  };
  const LinkIndex ground = plan.mechanism().ground();
  for (const LinkIndex link : configuration.links.keys()) {
    if (link != ground) {
      forget(configuration.links[link]);
    }
  }
  std::for_each(configuration.slides.begin(), configuration.slides.end(), forget);
  std::for_each(configuration.outputs.begin(), configuration.outputs.end(), forget);
  configuration.derivatives_known = true;
  return configuration;
}

[[nodiscard]] inline bool is_reported(const Report& report, std::size_t configuration) {
  return report.branch == 0 || configuration + 1 == static_cast<std::size_t>(report.branch);
}

}  // namespace assur::mechanism
