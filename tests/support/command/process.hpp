// Runs the command `assur` with any descriptor as standard output, and returns its status, its
// messages and its peak memory.
#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "command/command.hpp"

namespace assur::test {

struct ProcessResult {
  int status = -1;
  long peak_kilobytes = 0;
  std::string messages;
};

/// `output` becomes the standard output and is closed here. Unless `largest_file` is 0, a file that
/// grows beyond that many bytes fails as on a full disk.
inline ProcessResult run_process(const std::vector<std::string>& arguments, int output,
                                 unsigned long largest_file = 0) {
  const TemporaryDirectory directory;
  const std::string messages = (directory.path() / "messages").string();
  std::vector<std::string> words = {ASSUR_COMMAND};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  const int errors = open(messages.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  const pid_t child = fork();
  if (child == 0) {
    if (largest_file != 0) {
      const rlimit limit{largest_file, largest_file};
      (void)setrlimit(RLIMIT_FSIZE, &limit);
    }
    (void)dup2(output, STDOUT_FILENO);
    (void)dup2(errors, STDERR_FILENO);
    (void)execv(pointers[0], pointers.data());
    _exit(127);
  }
  (void)close(output);
  (void)close(errors);
  ProcessResult result;
  int status = 0;
  rusage usage{};
  (void)wait4(child, &status, 0, &usage);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  result.peak_kilobytes = usage.ru_maxrss;
  result.messages = read_file(messages);
  return result;
}

/// A device or file to write to.
inline int opened(const std::string& path) {
  return open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
}

/// The end to write to of a pipe that nobody reads.
inline int closed_pipe() {
  std::array<int, 2> ends{};
  (void)pipe2(ends.data(), O_CLOEXEC);
  (void)close(ends[0]);
  return ends[1];
}

}  // namespace assur::test
