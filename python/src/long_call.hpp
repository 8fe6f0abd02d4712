// Turns Ctrl-C into the end of a long call that runs without the interpreter's lock.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>

namespace assur::python {

/// Lets other threads of Python run while it lives, and asks now and then for signals.
class LongCall {
 public:
  /// Throws what a signal raises, as KeyboardInterrupt; cheap to call.
  void go_on() {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) {
      return;
    }
    next_ = now + interval;
    const pybind11::gil_scoped_acquire held;
    if (PyErr_CheckSignals() != 0) {
      throw pybind11::error_already_set();
    }
  }

 private:
  static constexpr std::chrono::milliseconds interval{50};

  pybind11::gil_scoped_release others_run_;
  std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + interval;
};

}  // namespace assur::python
