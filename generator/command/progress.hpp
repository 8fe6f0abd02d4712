// Turns the number of steps done into a bar on a terminal's standard error.
#pragma once

#include <chrono>
#include <cstdint>

namespace assur::generator::command {

/// One line that is drawn anew, and erased at the end; nothing before a time of silence is over.
/// Where standard error is not a terminal, nothing is written.
class ProgressBar {
 public:
  explicit ProgressBar(std::uint64_t count, std::chrono::seconds silence = {});
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  void show(std::uint64_t done);

 private:
  std::uint64_t count_;
  int percent_ = -1;
  bool terminal_;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace assur::generator::command
