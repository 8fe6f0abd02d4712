// Turns a solution into text for people, JSON or CSV for programs.
#pragma once

#include <string>
#include <vector>

#include "scene/solve.hpp"

namespace assur::generator {

/// A solution with the parameter values that it belongs to.
struct SolvedScene {
  const Scene* scene;
  const ParameterValues* values;
  const Solution* solution;
};

/// The contract's JSON object.
[[nodiscard]] std::string report_json(const SolvedScene& solved);
/// Tables for people, angles in degrees.
[[nodiscard]] std::string report_text(const SolvedScene& solved);
/// The head of a table with one row a configuration.
[[nodiscard]] std::string csv_header(const Scene& scene);
/// The rows of one solution. `step` numbers the rows of a sweep.
[[nodiscard]] std::string csv_rows(const SolvedScene& solved, int step);

}  // namespace assur::generator
