// Turns a file of another program into a scene file.
#pragma once

#include <string>

namespace assur::generator::command {

struct ImportOptions {
  std::string source;  ///< a file, or a shared link or expression itself
  std::string output;
  std::string driver;  ///< of an expression of Pyslvs: the point of the driven joint
  bool replace = false;
};

/// Writes the scene, and a line for each thing that it does not say on standard error. Returns
/// whether all that holds or drives the mechanism is in it. Throws InputError for what cannot be
/// read, and where the scene cannot be written: nothing is written then.
[[nodiscard]] bool import_file(const ImportOptions& options);

}  // namespace assur::generator::command
