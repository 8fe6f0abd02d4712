// Turns the number of steps done into a bar on a terminal's standard error.
#pragma once

#include <chrono>
#include <cstdint>

namespace assur::generator::command {

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
