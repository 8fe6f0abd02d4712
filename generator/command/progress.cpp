#include "command/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <string>

namespace assur::generator::command {

ProgressBar::ProgressBar(int count) : count_(count), terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
  if (terminal_ && percent_ >= 0) {
    std::cerr << "\r\x1b[K" << std::flush;
  }
}

void ProgressBar::show(int done) {
  const int percent = static_cast<int>(100.0 * done / count_);
  if (!terminal_ || percent == percent_) {
    return;
  }
  percent_ = percent;
  std::string bar(40, ' ');
  std::fill_n(bar.begin(), percent * 2 / 5, '#');
  std::cerr << "\r[" << bar << "] " << percent << " %" << std::flush;
}

}  // namespace assur::generator::command
