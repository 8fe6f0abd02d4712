// Sorting of short lists by keys whose entries have rounding errors.
#pragma once

#include <algorithm>
#include <assur/numeric/precision.hpp>
#include <cmath>
#include <cstddef>

namespace assur::numeric {

/// Two key entries differ if their difference exceeds this, relative to the larger of the entry and
/// its unit: 1e-6 in double, 1e-3 in float. Rounding moves a double configuration by the square
/// root of epsilon.
template <typename Scalar>
inline constexpr Scalar key_rounding = static_cast<Scalar>(last_regular_digit<Scalar>);

/// Whether two entries of keys differ by more than rounding.
template <typename Scalar>
[[nodiscard]] bool are_apart(Scalar left, Scalar right, Scalar one = 1) {
  return std::abs(left - right) > key_rounding<Scalar> * (one + std::abs(left));
}

/// Whether one key comes before another of its size, by the first entry from index `from` on that
/// differs; the entries before are equal. From `lengths_from` on, entries have the unit `one`. A
/// difference is relative to the larger of the entry and its unit, and must exceed `key_rounding`.
/// Two keys that are close as a whole belong to configurations that meet. There every difference
/// falls with the distance, so each is taken relative to the largest: the first entry that differs
/// stays the first.
template <typename Key>
[[nodiscard]] bool comes_before(const Key& left, const Key& right, std::size_t lengths_from,
                                typename Key::value_type one, std::size_t from = 0) {
  using Scalar = typename Key::value_type;
  constexpr auto close = static_cast<Scalar>(1e-2);
  constexpr Scalar equal = static_cast<Scalar>(1e-13) * roundings_of_double<Scalar>;
  const auto difference = [&](std::size_t place) {
    const Scalar unit = place < lengths_from ? Scalar(1) : one;
    return (left[place] - right[place]) / (unit + std::abs(left[place]));
  };
  if (from < left.size() &&
      are_apart(left[from], right[from], from < lengths_from ? Scalar(1) : one)) {
    return left[from] < right[from];
  }
  Scalar farthest = 0;
  for (std::size_t place = from; place < left.size(); ++place) {
    farthest = (std::max)(farthest, std::abs(difference(place)));
  }
  const Scalar least =
      (std::max)(equal, key_rounding<Scalar> * (std::min)(Scalar(1), farthest / close));
  for (std::size_t place = from; place < left.size(); ++place) {
    if (std::abs(difference(place)) > least) {
      return difference(place) < 0;
    }
  }
  return false;
}

/// Sorts `count` entries, given by their indices, by insertion: the sort is stable, and a
/// comparison that is not transitive, as of keys with a tolerance, does no harm.
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
