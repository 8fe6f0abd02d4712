// What the command writes: answers to standard output, remarks and progress to standard error.
#pragma once

#include <chrono>
#include <cstdint>
#include <ostream>
#include <string>

namespace assur::generator::command {

/// Thrown when the reader has closed the pipe, as `| head` does, and wants no more output.
struct ClosedPipe {};

/// Writes to standard output. Throws InputError where that fails, because the disk is full for
/// instance, and ClosedPipe.
void print(const std::string& text);

/// Writes out what is still buffered, and throws as `print` does.
void finish_output();

/// Standard error, or nowhere after `silence_remarks`. Errors are not remarks: always shown.
[[nodiscard]] std::ostream& remarks();

void silence_remarks();
[[nodiscard]] bool remarks_are_silent();

/// One line that is redrawn, and erased at the end. It does not appear in the first second, so that
/// quick commands show none. Where standard error is not a terminal, or remarks are silent, nothing
/// is written.
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
