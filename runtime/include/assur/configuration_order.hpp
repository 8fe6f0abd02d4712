// Turns a mechanism's configuration into the key by which its configurations are put in order.
#pragma once

#include <array>
#include <assur/variables.hpp>
#include <cmath>
#include <cstddef>
#include <utility>

namespace assur {

/// Sums over all pairs of moving links, of the cosines of the angles between them, of the cosines'
/// squares and cubes, and of the sines. They depend neither on where the mechanism stands nor on
/// the order in which its links are listed, the cosines not on reflection. `directions` is a range
/// of Direction<double>, one a link.
template <typename Directions>
[[nodiscard]] std::array<double, 4> turning_sums(const Directions& directions) {
  std::array<double, 4> sums{};
  for (std::size_t one = 0; one < directions.size(); ++one) {
    for (std::size_t other = one + 1; other < directions.size(); ++other) {
      const Direction<double> between = turned(directions[other], reversed(directions[one]));
      sums[0] += between.cos;
      sums[1] += between.cos * between.cos;
      sums[2] += between.cos * between.cos * between.cos;
      sums[3] += between.sin;
    }
  }
  return sums;
}

/// Whether one key comes before another of its size, entry by entry; entries that differ by
/// rounding alone count as equal. A key is the turning sums, then the displacements of the slides.
template <typename Key>
[[nodiscard]] bool comes_before(const Key& left, const Key& right) {
  for (std::size_t place = 0; place < left.size(); ++place) {
    const double difference = left[place] - right[place];
    if (std::abs(difference) > 1e-9 * (1 + std::abs(left[place]))) {
      return difference < 0;
    }
  }
  return false;
}

/// Puts the first `count` configurations in the order of their keys; equal keys keep their places.
template <typename Configurations, typename Keys>
void put_in_order(Configurations& configurations, Keys& keys, int count) {
  for (auto last = 1; last < count; ++last) {
    for (auto at = static_cast<std::size_t>(last); at > 0 && comes_before(keys[at], keys[at - 1]);
         --at) {
      std::swap(keys[at], keys[at - 1]);
      std::swap(configurations[at], configurations[at - 1]);
    }
  }
}

}  // namespace assur
