#include "command/output.hpp"

#include <assur/text/error.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>

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

}  // namespace assur::generator::command
