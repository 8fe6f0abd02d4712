// Every assembly configuration of a planned mechanism at given values.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>
#include <memory>
#include <vector>

#include "nearby_configurations.hpp"
#include "other_constraints.hpp"
#include "search_options.hpp"

namespace assur::mechanism::solve {

class ConfigurationWalk;

/// Solves a mechanism at the present values, in memory that it keeps from one call to the next.
class MechanismSolver {
 public:
  /// The values must outlive the solver, and stay where they are.
  explicit MechanismSolver(const Values& values);
  ~MechanismSolver();
  MechanismSolver(const MechanismSolver&) = delete;
  MechanismSolver& operator=(const MechanismSolver&) = delete;

  /// Writes the sought configurations. Throws MechanismError where there are too many to list, or
  /// where they cannot be found in a bounded time, and as `Plan::solve` does; where redundant
  /// constraints hold in no configuration, the answer has a refusal instead.
  [[nodiscard]] Answer solve(const SearchOptions& search, const Sought& sought, Solution& result);
  /// See `TurnCount::count_from`.
  void count_from(std::vector<NearbyConfigurations> nearby);
  /// See `TurnCount`; refers to the last solution.
  [[nodiscard]] bool is_count_ambiguous() const;
  [[nodiscard]] bool is_count_in_doubt() const;

 private:
  std::unique_ptr<ConfigurationWalk> walk_;
  OtherConstraints others_;
};

}  // namespace assur::mechanism::solve
