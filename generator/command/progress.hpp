// Turns the number of steps done into a bar on a terminal's standard error.
#pragma once

#include <chrono>
#include <cstdint>

namespace assur::generator::command {

/// One line that is drawn anew, and erased at the end; nothing in the first second. Where standard
/// error is not a terminal, or nobody wants it, nothing is written.
class ProgressBar {
 public:
  explicit ProgressBar(std::uint64_t count, bool is_wanted = true);
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  void show(std::uint64_t done);

 private:
  std::uint64_t count_;
  int percent_ = -1;
  bool is_shown_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace assur::generator::command
