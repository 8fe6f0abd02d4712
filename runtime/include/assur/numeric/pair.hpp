// Pairs: arithmetic on two numbers at once.
#pragma once

#include <assur/model.hpp>
#include <assur/numeric/pack.hpp>
#include <cstddef>
#include <type_traits>

namespace assur::numeric {

/// Two numbers processed at once.
template <typename Scalar>
using PairOf = PackOf<Scalar, 2>;
using Pair = PairOf<double>;

/// One number of a pair; a plain number stands for both.
template <typename Scalar>
[[nodiscard]] Scalar lane(const PairOf<Scalar>& pair, std::size_t index) {
  return pair[index];
}
template <typename Scalar, std::enable_if_t<std::is_floating_point_v<Scalar>, int> = 0>
[[nodiscard]] Scalar lane(Scalar number, std::size_t /*index*/) {
  return number;
}
template <typename Scalar>
[[nodiscard]] auto lane(const Direction<Scalar>& direction, std::size_t index) {
  const auto cos = lane(direction.cos, index);
  return Direction<std::decay_t<decltype(cos)>>{cos, lane(direction.sin, index)};
}

/// The first of a pair, and another number as the second.
[[nodiscard]] inline Pair paired(const Pair& first, double second) { return {first[0], second}; }
[[nodiscard]] inline Direction<Pair> paired(const Direction<Pair>& first,
                                            const Direction<double>& second) {
  return {paired(first.cos, second.cos), paired(first.sin, second.sin)};
}

}  // namespace assur::numeric
