// Output of the command: answers to standard output, remarks and progress to standard error.
#pragma once

#include <chrono>
#include <cstdint>
#include <ostream>
#include <string>

namespace assur::generator::command {

/// Thrown when the reader has closed the pipe, as `| head` does.
struct ClosedPipe {};

/// Writes to standard output. Throws InputError if that fails, for instance on a full disk, and
/// ClosedPipe.
void print(const std::string& text);

/// Writes buffered output, and throws as `print` does.
void finish_output();

/// Standard error, or nothing after `silence_remarks`; errors are always shown.
[[nodiscard]] std::ostream& remarks();

void silence_remarks();
[[nodiscard]] bool remarks_are_silent();

/// One line that is redrawn, and erased at the end. It appears after one second, so that quick
/// commands show none. Nothing is written if standard error is not a terminal, or remarks are
/// silenced.
class ProgressBar {
 public:
  ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  void show(std::uint64_t done, std::uint64_t count);

 private:
  int percent_ = -1;
  bool is_drawn_;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace assur::generator::command
