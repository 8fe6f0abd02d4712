// Turns a command line into the outcome of running it within limits of time and memory.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace assur::generator::audit::running {

struct ProcessLimits {
  double seconds = 10;
  std::size_t bytes = 0;  ///< of address space; zero: no limit
};

struct ProcessEnd {
  enum class Kind : unsigned char { ended, not_found, killed, too_long };

  Kind kind = Kind::ended;
  int code = 0;        ///< the exit status, or the signal that killed it
  std::string output;  ///< the beginning of what both its streams gave
};

/// Runs a command, which is looked for in PATH, in a directory, with no input, a few plain
/// environment variables and files of at most 64 MB. Ends what the command leaves running.
[[nodiscard]] ProcessEnd run_process(const std::vector<std::string>& command,
                                     const std::filesystem::path& directory,
                                     const std::filesystem::path& home,
                                     const ProcessLimits& limits);

}  // namespace assur::generator::audit::running
