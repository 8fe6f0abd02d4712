// Targets of speed and accuracy: bounds on the ratio of two rows of one run.
#pragma once

#include "table/row.hpp"

namespace assur::speed {

enum class Measure : unsigned char { time, error };

/// The cost, or the error, of `method` is at most this part of that of `peer` on the task.
struct Target {
  const char* task;
  const char* method;
  const char* peer;
  Measure measure;
  double at_most;
};

[[nodiscard]] const std::vector<Target>& targets();

/// The double-precision row, or nullptr.
[[nodiscard]] const Row* find_row(const std::vector<Task>& tasks, const std::string& task,
                                  const std::string& method);

[[nodiscard]] inline double measured(const Target& target, const Row& ours, const Row& peer) {
  return target.measure == Measure::time ? ours.ns / peer.ns : ours.error_999 / peer.error_999;
}

}  // namespace assur::speed
