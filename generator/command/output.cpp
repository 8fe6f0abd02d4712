#include "command/output.hpp"

#include <unistd.h>

#include <algorithm>
#include <assur/text/error.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>

namespace assur::generator::command {

namespace {

[[noreturn]] void fail() {
  const int reason = errno;
  if (reason == EPIPE) {
    throw ClosedPipe();
  }
  throw text::InputError(std::string("standard output: cannot be written: ") +
                         std::strerror(reason));
}

}  // namespace

void print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) {
    fail();
  }
}

void finish_output() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    fail();
  }
}

namespace {

std::ostream& nowhere() {
  static std::ostream stream(nullptr);
  return stream;
}

bool& silence() {
  static bool is_silent = false;
  return is_silent;
}

}  // namespace

std::ostream& remarks() { return remarks_are_silent() ? nowhere() : std::cerr; }

void silence_remarks() { silence() = true; }

bool remarks_are_silent() { return silence(); }

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
