#include "command/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <string>

namespace assur::generator::command {

ProgressBar::ProgressBar(std::uint64_t count, std::chrono::seconds silence)
    : count_(count),
      terminal_(isatty(STDERR_FILENO) != 0),
      begin_(std::chrono::steady_clock::now() + silence) {}

ProgressBar::~ProgressBar() {
  if (terminal_ && percent_ >= 0) {
    std::cerr << "\r\x1b[K" << std::flush;
  }
}

void ProgressBar::show(std::uint64_t done) {
  const int percent =
      static_cast<int>(100 * static_cast<double>(done) / static_cast<double>(count_));
  if (!terminal_ || percent == percent_ || std::chrono::steady_clock::now() < begin_) {
    return;
  }
  percent_ = percent;
  std::string bar(40, ' ');
  std::fill_n(bar.begin(), std::min(percent, 100) * 2 / 5, '#');
  std::cerr << "\r[" << bar << "] " << percent << " %" << std::flush;
}

}  // namespace assur::generator::command
