// Turns a short list into a sorted one, by keys whose entries carry rounding errors.
#pragma once

#include <cmath>
#include <cstddef>

namespace assur::numeric {

/// Whether one key comes before another of its size, entry by entry; entries that differ by
/// rounding alone, relative to the larger of themselves and one, count as equal. Rounding moves a
/// double configuration by the root of epsilon.
template <typename Key>
[[nodiscard]] bool comes_before(const Key& left, const Key& right) {
  for (std::size_t place = 0; place < left.size(); ++place) {
    const double difference = left[place] - right[place];
    if (std::abs(difference) > 1e-6 * (1 + std::abs(left[place]))) {
      return difference < 0;
    }
  }
  return false;
}

/// Sorts `count` entries, given by their places, by insertion: equal ones keep their places, and
/// a comparison that is not transitive, as of keys with a tolerance, does no harm.
template <typename Before, typename Exchange>
void insertion_sort(std::size_t count, Before before, Exchange exchange) {
  for (std::size_t last = 1; last < count; ++last) {
    for (std::size_t at = last; at > 0 && before(at, at - 1); --at) {
      exchange(at, at - 1);
    }
  }
}

}  // namespace assur::numeric
