// Turns a scene file into what `assur solve` prints for it.
#pragma once

#include <string>

#include "command/sweep.hpp"

namespace assur::generator::command {

/// What a solution and a sweep are asked for alike, and what only a solution is.
struct SolveOptions : SweepOptions {
  std::string format = "text";  ///< csv: over the scene's sweep, if it has one
  bool prove = false;           ///< enclose all complex configurations of every group
  bool circuits = false;        ///< also the branch and circuit of each configuration in the sweep
};

/// Solves or sweeps the scene, prints the result to standard output, and returns whether it is
/// negative: the structure is degenerate. Throws InputError for what cannot be used; in a sweep,
/// before anything is printed, except for a branch that does not exist.
[[nodiscard]] bool print_solution(const SolveOptions& options);

}  // namespace assur::generator::command
