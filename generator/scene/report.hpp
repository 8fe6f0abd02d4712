// Turns a solution into text for people, JSON or CSV for programs.
#pragma once

#include <string>
#include <vector>

#include "scene/solve.hpp"
#include "scene/sweep.hpp"

namespace assur::generator {

/// A solution with the parameter values that it belongs to.
struct SolvedScene {
  const Scene* scene;
  const ParameterValues* values;
  const Solution* solution;
  int branch = 0;  ///< number of the one configuration to report, or 0 for all

  [[nodiscard]] bool reports(std::size_t configuration) const {
    return branch == 0 || configuration + 1 == static_cast<std::size_t>(branch);
  }
};

/// The contract's JSON object.
[[nodiscard]] std::string report_json(const SolvedScene& solved);
/// Tables for people, angles in degrees.
[[nodiscard]] std::string report_text(const SolvedScene& solved);
/// The head of a table with one row a configuration.
[[nodiscard]] std::string csv_header(const Scene& scene);
/// The rows of one solution, without a sweep.
[[nodiscard]] std::string csv_rows(const SolvedScene& solved);
/// One row of a sweep: a configuration on its branch, or an event.
[[nodiscard]] std::string csv_row(const Scene& scene, const SweepRecord& record);

}  // namespace assur::generator
