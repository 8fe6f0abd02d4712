// Order of two configurations in each of several groups.
#pragma once

#include <array>
#include <assur/detail/assembly_order.hpp>
#include <assur/numeric/order.hpp>
#include <cstddef>

namespace assur::detail::batch {

/// The keys of a configuration, in the order of `for_each_key`.
template <typename Model, typename Pack>
using Keys = std::array<Pack, size(Model::link_count) * size(Model::link_count - 1) +
                                  size(Model::unknown_count)>;
template <typename Model, typename Pack>
void put_keys(const typename Model::template Dimensions<Pack>& d,
              const typename Model::template Inputs<Pack>& u,
              const typename Model::template Configuration<Pack>& q, Keys<Model, Pack>& keys) {
  keys.fill(Pack(0));
  for_each_key<Model, Pack>(d, u, q, [&keys](const Pack& key, int place, bool /*is_length*/) {
    entry(keys, place) = key;
  });
}

/// Whether the first of two configurations comes before the second by all keys, as in
/// `numeric::comes_before`; `one` is the unit of lengths.
template <typename Model, typename Pack>
[[nodiscard, gnu::noinline]] auto come_before_by_keys(
    const typename Model::template Dimensions<Pack>& d,
    const typename Model::template Inputs<Pack>& u,
    const typename Model::template Configuration<Pack>& first,
    const typename Model::template Configuration<Pack>& second, const Pack& one) {
  using Scalar = typename numeric::PartOf<Pack>::Type;
  constexpr std::size_t turning = size(Model::link_count) * size(Model::link_count - 1);
  constexpr Scalar close = 1e-2;
  constexpr Scalar equal = 1e-13 * numeric::roundings_of_double<Scalar>;
  Keys<Model, Pack> left;
  Keys<Model, Pack> right;
  put_keys<Model, Pack>(d, u, first, left);
  put_keys<Model, Pack>(d, u, second, right);
  const auto apart_at_first =
      abs(left[0] - right[0]) >
      Pack(numeric::key_rounding<Scalar>) * ((turning > 0 ? Pack(1) : one) + abs(left[0]));
  const auto before_at_first = left[0] < right[0];
  Pack farthest(0);
  for (std::size_t place = 0; place < left.size(); ++place) {
    left[place] =
        (left[place] - right[place]) / ((place < turning ? Pack(1) : one) + abs(left[place]));
    farthest = max EIGEN_NOT_A_MACRO(farthest, abs(left[place]));
  }
  const Pack part = farthest * Pack(1 / close);
  const Pack least = max EIGEN_NOT_A_MACRO(
      Pack(equal), Pack(numeric::key_rounding<Scalar>) * select(part < Pack(1), part, Pack(1)));
  auto open = !apart_at_first;
  auto before = apart_at_first & before_at_first;
  for (const Pack& difference : left) {
    const auto tells = open & (abs(difference) > least);
    before = before | (tells & (difference < Pack(0)));
    open = open & !tells;
  }
  return before;
}

}  // namespace assur::detail::batch
