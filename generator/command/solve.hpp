// Turns a scene file into what `assur solve` prints for it.
#pragma once

#include <string>
#include <vector>

namespace assur::generator::command {

struct SolveOptions {
  std::string scene;
  std::vector<std::string> settings;
  std::string format = "text";
  int branch = 0;
  bool prove = false;      ///< enclose all complex configurations of every group
  bool nearest = false;    ///< the configuration, or the branch, nearest to the scene's reference
  bool circuits = false;   ///< also the branch and the circuit of each configuration in the sweep
  bool unwrapped = false;  ///< angles of a sweep continue by whole turns along a branch
};

/// Solves or sweeps the scene, prints the result to standard output, and returns whether it is
/// negative: the structure is degenerate. Throws InputError for what cannot be used; in a sweep,
/// before anything is printed, except for a branch that does not exist.
[[nodiscard]] bool print_solution(const SolveOptions& options);

}  // namespace assur::generator::command
