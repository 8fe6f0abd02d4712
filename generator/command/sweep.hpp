// Turns a scene file with a sweep into the rows of its branches, as `assur sweep` prints them.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/scene_file.hpp>
#include <string>
#include <vector>

namespace assur::generator::command {

struct SweepOptions {
  std::string scene;
  std::vector<std::string> settings;
  int branch = 0;          ///< the rows of this branch alone; 0 for those of all, and of events
  bool nearest = false;    ///< the rows of the branch nearest to the scene's reference
  bool unwrapped = false;  ///< angles continue by whole turns along a branch
};

/// Follows the branches over the scene's sweep, prints their rows to standard output as they are
/// computed, and returns whether the result is negative: the structure is degenerate at a step.
/// Throws InputError for what cannot be used, before anything is printed, except for a branch that
/// does not exist.
[[nodiscard]] bool run_sweep(const SweepOptions& options);

/// The same for a scene that is read and planned. Throws also MechanismError.
[[nodiscard]] bool print_sweep(const SweepOptions& options, const mechanism::Scene& scene,
                               const mechanism::Plan& plan);

}  // namespace assur::generator::command
