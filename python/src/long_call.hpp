// Release of the interpreter's lock during long calls, and their interruption by Ctrl-C.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <optional>
#include <thread>

namespace assur::python {

/// Releases the interpreter's lock during its lifetime, in which no Python object may be touched,
/// not even its reference count.
class OthersRun {
 public:
  OthersRun() : state_(PyEval_SaveThread()) {}
  OthersRun(const OthersRun&) = delete;
  OthersRun& operator=(const OthersRun&) = delete;
  ~OthersRun() { take_lock(); }

  /// Throws the exception that a signal raises, such as KeyboardInterrupt.
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
  /// After its end the interpreter would unwind a daemon thread here, and release objects that no
  /// longer exist; so the thread waits for the end of the process instead.
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

/// The same for a long call: it checks for signals now and then.
class LongCall {
 public:
  /// Throws the exception that a signal raises; cheap to call.
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
