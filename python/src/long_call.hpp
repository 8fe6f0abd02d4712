// Turns long calls into ones that let other threads of Python run, and that Ctrl-C ends.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <optional>
#include <thread>

namespace assur::python {

/// Lets other threads of Python run while it lives, so that nothing may touch an object of Python
/// then, not even the count of its references.
class OthersRun {
 public:
  OthersRun() : state_(PyEval_SaveThread()) {}
  OthersRun(const OthersRun&) = delete;
  OthersRun& operator=(const OthersRun&) = delete;
  ~OthersRun() { take_lock(); }

  /// Throws what a signal raises, as KeyboardInterrupt.
  void expect_no_signal() {
    std::optional<pybind11::error_already_set> raised;
    take_lock();
    if (PyErr_CheckSignals() != 0) {
      raised.emplace();
    }
    state_ = PyEval_SaveThread();
    if (raised) {
      throw pybind11::error_already_set(*raised);
    }
  }

 private:
  /// Where the interpreter has ended, it unwinds a daemon's thread here. Objects that this would
  /// release are gone by then, so the thread waits for the end of the process instead.
  void take_lock() noexcept {
    try {
      PyEval_RestoreThread(state_);
    } catch (...) {
      while (true) {
        std::this_thread::sleep_for(std::chrono::hours(1));
      }
    }
  }

  PyThreadState* state_;
};

/// The same for a call that takes long: it asks now and then for signals.
class LongCall {
 public:
  /// Throws what a signal raises; cheap to call.
  void go_on() {
    const auto now = std::chrono::steady_clock::now();
    if (now >= next_) {
      next_ = now + interval;
      others_run_.expect_no_signal();
    }
  }

 private:
  static constexpr std::chrono::milliseconds interval{50};

  OthersRun others_run_;
  std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + interval;
};

}  // namespace assur::python
