// The sort key of a mechanism's configurations, independent of position, unit and listing.
#pragma once

#include <algorithm>
#include <assur/directions.hpp>
#include <assur/numeric/order.hpp>
#include <cmath>
#include <cstddef>
#include <utility>

namespace assur::support {

/// The number of entries of `turning_key` for a number of links.
[[nodiscard]] constexpr std::size_t turning_key_size(std::size_t links) {
  return links < 2 ? 4 : 2 + 2 * links;
}

/// Computes sums over all pairs of moving links: of the cosines of the angles between them, of the
/// cosines' squares and cubes, and of the sines; then every further link's angle against the first,
/// as cosine and sine. They are invariant under rigid motion, and the cosines also under
/// reflection. The links must come in an order that does not depend on the listing, such as that of
/// their names. `directions` is a range of directions, `key` one with room for turning_key_size
/// entries. If `From` is 3, the entries before that place are not set.
template <std::size_t From = 0, typename Directions, typename Key>
void turning_key(const Directions& directions, Key& key) {
  static_assert(From == 0 || From == 3, "the sums of the cosines are set together");
  using Scalar = typename Key::value_type;
  Scalar cosines = 0;
  Scalar squares = 0;
  Scalar cubes = 0;
  Scalar sines = 0;
  for (std::size_t one = 0; one < directions.size(); ++one) {
    for (std::size_t other = one + 1; other < directions.size(); ++other) {
      const Direction<Scalar> between = turned(directions[other], reversed(directions[one]));
      cosines += between.cos;
      squares += between.cos * between.cos;
      cubes += between.cos * between.cos * between.cos;
      sines += between.sin;
      if (one == 0) {
        key[2 + 2 * other] = between.cos;
        key[3 + 2 * other] = between.sin;
      }
    }
  }
  if constexpr (From == 0) {
    key[0] = cosines;
    key[1] = squares;
    key[2] = cubes;
  }
  key[3] = sines;
}

/// Sorts the first `count` configurations by their keys; `exchange` exchanges the configurations at
/// two places. The sort is stable. A key is the turning key followed, from index `lengths_from` on,
/// by the displacements of the slides, which are compared relative to the longest of all. The
/// entries before index `from` are equal in all keys.
template <typename Keys, typename Exchange>
void put_in_order(Keys& keys, int count, std::size_t lengths_from, const Exchange& exchange,
                  std::size_t from = 0) {
  const auto size = static_cast<std::size_t>(count);
  typename Keys::value_type::value_type longest = 0;
  for (std::size_t index = 0; index < size; ++index) {
    for (std::size_t place = lengths_from; place < keys[index].size(); ++place) {
      longest = (std::max)(longest, std::abs(keys[index][place]));
    }
  }
  numeric::insertion_sort(
      size,
      [&keys, lengths_from, longest, from](std::size_t one, std::size_t other) {
        return numeric::comes_before(keys[one], keys[other], lengths_from, longest, from);
      },
      [&keys, &exchange, size](std::size_t one, std::size_t other) {
        if (size > 2) {  // with two configurations no key is read again
          std::swap(keys[one], keys[other]);
        }
        exchange(one, other);
      });
}

}  // namespace assur::support
