// Turns the values of a planned mechanism into every assembly configuration.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>
#include <memory>

namespace assur::mechanism::solve {

class ConfigurationWalk;

/// Solves a mechanism wherever its values are set, in memory that it keeps from one to the next.
class MechanismSolver {
 public:
  /// The values must outlive the solver, and stay where they are.
  explicit MechanismSolver(const Values& values);
  ~MechanismSolver();
  MechanismSolver(const MechanismSolver&) = delete;
  MechanismSolver& operator=(const MechanismSolver&) = delete;

  /// See `Plan::solve`. On demand a solution without configurations tells by how much the links
  /// fail to close, which takes longer than to solve.
  void solve(bool measure_gap, Solution& result);

 private:
  std::unique_ptr<ConfigurationWalk> walk_;
};

}  // namespace assur::mechanism::solve
