// Turns a solution into text for people, JSON or CSV for programs.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/sweep.hpp>
#include <string>

namespace assur::mechanism {

/// A solution, with the plan and the values that were solved.
struct Report {
  const Plan& plan;
  const Values& values;
  const Solution& solution;
  std::string title;  ///< for people, where the mechanism has no name
  int branch = 0;     ///< number of the one configuration to report, or 0 for all
  std::optional<Nearest> nearest =
      std::nullopt;  ///< set where it was asked for, and then reported as such
  /// Whether the one configuration is alone in the solution; the number of the nearest one is then
  /// not known.
  bool alone = false;
};

/// Returns the JSON object of the scene format (docs/reference/scene_format.md).
[[nodiscard]] std::string report_json(const Report& report);
/// Tables for people, angles in degrees.
[[nodiscard]] std::string report_text(const Report& report);
/// The head of a table with one row per configuration.
[[nodiscard]] std::string csv_header(const Plan& plan);
/// The rows of one solution, without a sweep.
[[nodiscard]] std::string csv_rows(const Report& report);
/// Adds one row of a sweep to a text: a configuration on its branch, or an event.
void add_csv_row(const Plan& plan, const SweepRecord& record, std::string& text);

}  // namespace assur::mechanism
