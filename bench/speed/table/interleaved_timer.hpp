// Times methods in turn, interleaved so that drift of the machine's speed affects all alike.
#pragma once

#include <vector>

#include "table/row.hpp"

namespace assur::speed {

struct TimerSettings {
  int rounds = 15;         ///< over all inputs
  std::size_t slices = 8;  ///< number of parts into which the inputs are divided
  /// A method that takes longer over one slice is timed in the first round only.
  double patience_ms = 20;
};

/// Fills in the times. In every round and for every slice of the inputs the methods run in turn,
/// each time beginning with the next one: each runs untimed over the slice before, so that caches
/// and branch predictors hold this method but not these inputs, and is then timed. The time is the
/// thread's own, so that other programs on the processor do not count, less what reading the clock
/// takes. A row's time is the median.
void measure(std::vector<Task>& tasks, const TimerSettings& settings);

}  // namespace assur::speed
