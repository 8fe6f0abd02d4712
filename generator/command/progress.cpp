#include "command/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <string>

#include "command/remarks.hpp"

namespace assur::generator::command {

ProgressBar::ProgressBar()
    : is_drawn_(isatty(STDERR_FILENO) != 0 && !remarks_are_silent()),
      begin_(std::chrono::steady_clock::now() + std::chrono::seconds(1)) {}

ProgressBar::~ProgressBar() {
  if (percent_ >= 0) {
    std::cerr << "\r\x1b[K" << std::flush;
  }
}

void ProgressBar::show(std::uint64_t done, std::uint64_t count) {
  const int percent = count == 0
                          ? 100
                          : static_cast<int>(std::min(100.0, 100 * static_cast<double>(done) /
                                                                 static_cast<double>(count)));
  if (!is_drawn_ || percent == percent_ || std::chrono::steady_clock::now() < begin_) {
    return;
  }
  percent_ = percent;
  std::string bar(40, ' ');
  std::fill_n(bar.begin(), percent * 2 / 5, '#');
  std::cerr << "\r[" << bar << "] " << percent << " %" << std::flush;
}

}  // namespace assur::generator::command
