// Runs the command `assur` as a user does: arguments in, output, messages and exit status out.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace assur::test {

struct CommandResult {
  int status = -1;
  std::string output;
  std::string messages;
};

inline std::string read_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// A new empty directory for one test, removed with it.
class TemporaryDirectory {
 public:
  TemporaryDirectory() {
    std::string name = (std::filesystem::temp_directory_path() / "assur-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  ~TemporaryDirectory() { std::filesystem::remove_all(path_); }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Writes a file and gives its path.
  // NOLINTNEXTLINE(modernize-use-nodiscard): it writes, and a caller may not need the path
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// Runs `assur` with arguments that the shell splits, its messages to a file or a device.
inline CommandResult run_assur_with_messages_to(const std::string& messages,
                                                const std::string& arguments) {
  const std::string line = std::string(ASSUR_COMMAND) + " " + arguments + " 2>" + messages;
  CommandResult result;
  FILE* pipe = popen(line.c_str(), "r");
  std::array<char, 4096> buffer{};
  std::size_t count = 0;
  while ((count = fread(buffer.data(), 1, buffer.size(), pipe)) > 0) {
    result.output.append(buffer.data(), count);
  }
  const int status = pclose(pipe);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

/// Runs `assur` with arguments that the shell splits.
inline CommandResult run_assur(const std::string& arguments) {
  const TemporaryDirectory directory;
  const std::string messages = (directory.path() / "messages").string();
  CommandResult result = run_assur_with_messages_to(messages, arguments);
  result.messages = read_file(messages);
  return result;
}

}  // namespace assur::test
