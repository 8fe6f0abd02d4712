// Turns a short list into a sorted one, by keys whose entries carry rounding errors.
#pragma once

#include <cmath>
#include <cstddef>

namespace assur::numeric {

/// -1 or 1 if one entry of a key comes before or after another; 0 if they differ by rounding alone,
/// relative to the larger of themselves and one, which may be another unit. Rounding moves a double
/// configuration by the root of epsilon.
[[nodiscard]] inline int order_of(double left, double right, double one = 1) {
  const double difference = left - right;
  if (!(std::abs(difference) > 1e-6 * (one + std::abs(left)))) {
    return 0;
  }
  return difference < 0 ? -1 : 1;
}

/// Whether one key comes before another of its size, entry by entry, where those before the one at
/// `from` are the same; from `lengths_from` on entries count in the unit `one`.
template <typename Key>
[[nodiscard]] bool comes_before(const Key& left, const Key& right, std::size_t lengths_from,
                                double one, std::size_t from = 0) {
  for (std::size_t place = from; place < left.size(); ++place) {
    const int order = order_of(left[place], right[place], place < lengths_from ? 1 : one);
    if (order != 0) {
      return order < 0;
    }
  }
  return false;
}

/// Sorts `count` entries, given by their places, by insertion: equal ones keep their places, and
/// a comparison that is not transitive, as of keys with a tolerance, does no harm.
template <typename Before, typename Exchange>
[[gnu::always_inline]] inline void insertion_sort(std::size_t count, Before before,
                                                  Exchange exchange) {
  for (std::size_t last = 1; last < count; ++last) {
    for (std::size_t at = last; at > 0 && before(at, at - 1); --at) {
      exchange(at, at - 1);
    }
  }
}

}  // namespace assur::numeric
