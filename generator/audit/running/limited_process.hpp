// A temporary directory for a program, and a run within limits of time and memory.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace assur::generator::audit::running {

class WorkDirectory {
 public:
  WorkDirectory();
  WorkDirectory(const WorkDirectory&) = delete;
  WorkDirectory& operator=(const WorkDirectory&) = delete;
  ~WorkDirectory();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  // NOLINTNEXTLINE(modernize-use-nodiscard): it writes, and callers that read by name need no path
  std::filesystem::path write(const std::string& name, const std::string& text) const;
  /// Empty if there is no such file.
  [[nodiscard]] std::string read(const std::string& name) const;

 private:
  std::filesystem::path path_;
};

struct ProcessLimits {
  double seconds = 10;
  std::size_t bytes = 0;  ///< of address space; zero: no limit
};

struct ProcessEnd {
  enum class Kind : unsigned char { ended, not_found, killed, too_long };

  Kind kind = Kind::ended;
  int code = 0;        ///< the exit status, or the signal that killed it
  std::string output;  ///< the beginning of both output streams
};

/// Runs a command, found by PATH, in a directory, with no input, a few plain environment variables
/// and files of at most 64 MB. Kills the processes that it leaves running.
[[nodiscard]] ProcessEnd run_process(const std::vector<std::string>& command,
                                     const std::filesystem::path& directory,
                                     const std::filesystem::path& home,
                                     const ProcessLimits& limits);

}  // namespace assur::generator::audit::running
