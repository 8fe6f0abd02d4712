// Turns a mechanism's configuration into the key by which its configurations are put in order.
#pragma once

#include <array>
#include <assur/directions.hpp>
#include <assur/numeric/order.hpp>
#include <cstddef>
#include <utility>

namespace assur::support {

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

/// Puts the first `count` configurations in the order of their keys; equal keys keep their places.
/// A key is the turning sums, then the displacements of the slides.
template <typename Configurations, typename Keys>
void put_in_order(Configurations& configurations, Keys& keys, int count) {
  numeric::insertion_sort(
      static_cast<std::size_t>(count),
      [&keys](std::size_t one, std::size_t other) {
        return numeric::comes_before(keys[one], keys[other]);
      },
      [&keys, &configurations](std::size_t one, std::size_t other) {
        std::swap(keys[one], keys[other]);
        std::swap(configurations[one], configurations[other]);
      });
}

}  // namespace assur::support
