// Turns the options of `assur emit` into files of C++.
#pragma once

#include <string>
#include <vector>

namespace assur::generator::command {

struct EmitOptions {
  bool all = false;
  int model = 0;
  std::string group = "tetrad";
  std::string scene;
  std::vector<std::string> variables;  ///< of the scene's parameters
  std::vector<std::string> wants;      ///< instead of the scene's; empty: the scene's
  std::vector<std::string> with;       ///< what a model's header holds beside its own functions
  std::string interface = "cpp";       ///< cpp, c or c-float
  std::string closures;
  std::string output;
  bool check = false;
};

/// Writes the files; with `check`, prints which are missing or differ instead, and returns false if
/// any does. Throws InputError for what cannot be emitted.
[[nodiscard]] bool run_emit(const EmitOptions& options);

}  // namespace assur::generator::command
