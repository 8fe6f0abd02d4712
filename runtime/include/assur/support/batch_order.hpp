// Order of two configurations in each of several instances of an emitted solver, and whether
// rounding could change it.
#pragma once

#include <array>
#include <assur/numeric/order.hpp>
#include <assur/numeric/pack.hpp>
#include <assur/support/displaced_frame.hpp>
#include <cstddef>

namespace assur::support {

/// The lanes of a pack in which one key comes before another by `numeric::comes_before`, and those
/// in which errors of many roundings in the keys would not change the answer.
template <typename Pack>
struct PackOrder {
  using Truth = decltype(Pack() < Pack());
  Truth before;
  Truth certain;

  template <std::size_t Size>
  PackOrder(const std::array<Pack, Size>& left, const std::array<Pack, Size>& right,
            std::size_t lengths_from, const Pack& longest, std::size_t from) {
    using Scalar = typename numeric::PartOf<Pack>::Type;
    const Pack counts(2 * numeric::key_rounding<Scalar>);
    const Pack counts_not(numeric::key_rounding<Scalar> / 2);
    const auto difference = [&](std::size_t place) {
      return (left[place] - right[place]) /
             ((place < lengths_from ? Pack(1) : longest) + abs(left[place]));
    };
    before = left[from] < right[from];
    certain = abs(left[from] - right[from]) >
              counts * ((from < lengths_from ? Pack(1) : longest) + abs(left[from]));
    if (static_cast<bool>(certain)) {
      return;
    }
    const Pack first = difference(from);
    // If keys are closer together as a whole, smaller differences decide.
    const Pack close(1.1e-2);
    Pack farthest = abs(first);
    Truth open = abs(first) < counts_not;
    Truth tells = open & !open;
    for (std::size_t place = from + 1; place < Size; ++place) {
      const Pack other = difference(place);
      farthest = larger(farthest, abs(other));
      const Truth is_told = open & (abs(other) > counts);
      before = (before & !is_told) | (is_told & (other < Pack(0)));
      tells = tells | is_told;
      open = open & (abs(other) < counts_not);
    }
    certain = certain | (tells & (farthest > close));
  }
};

}  // namespace assur::support
