// Table entries for the solution at one set of values.
#pragma once

#include <assur/mechanism/campaign.hpp>
#include <limits>

namespace assur::mechanism::campaign {

/// A number that a row does not have.
inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The outcome of a configuration within limits.
[[nodiscard]] inline Outcome outcome_of(const Configuration& configuration) {
  return configuration.regularity == Status::ok ? Outcome::regular : Outcome::near_singular;
}

/// The outcome of a solution without configurations.
[[nodiscard]] inline Outcome outcome_without_configurations(const Solution& solution) {
  return solution.status == SolutionStatus::degenerate ? Outcome::degenerate
         : !solution.breaches.empty()                  ? Outcome::beyond_limits
         : solution.dropped > 0                        ? Outcome::refused
                                                       : Outcome::no_assembly;
}

/// The columns of the outputs' coordinates.
inline void add_output_columns(const Mechanism& mechanism, std::vector<Column>& columns) {
  for (const Output& output : mechanism.outputs()) {
    columns.push_back({output.name + ".x", Column::Kind::real});
    columns.push_back({output.name + ".y", Column::Kind::real});
  }
}

/// Adds the outputs' coordinates to a row; NaN for null, which stands for no configuration.
inline void add_outputs(const Mechanism& mechanism, const Configuration* configuration,
                        std::vector<double>& row) {
  for (const OutputIndex output : mechanism.outputs().keys()) {
    if (configuration == nullptr) {
      row.insert(row.end(), {none, none});
    } else {
      const Eigen::Vector2d& position = configuration->outputs[output].position;
      row.insert(row.end(), {position.x(), position.y()});
    }
  }
}

/// The request reduced to positions, without the sweep and the covariance.
[[nodiscard]] inline Request positions_alone(Request request) {
  request.want = {true, false, false, false};
  request.sweep.reset();
  request.covariance.reset();
  return request;
}

}  // namespace assur::mechanism::campaign
