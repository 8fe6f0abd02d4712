// Variables of many groups as columns of numbers (a structure of arrays).
#pragma once

#include <assur/detail/numbers.hpp>
#include <cstddef>
#include <type_traits>

namespace assur {

/// data[p * stride + i] is number p of group i, in the order of `members`; a direction is two
/// numbers, its cosine and its sine. `Variables` is a model's Dimensions, Inputs or Configuration,
/// const if it is only read. A stride that is a multiple of 512 is slow: it maps all numbers of a
/// group to the same few cache lines.
template <typename Variables>
struct Columns {
  using Scalar = typename detail::ScalarOf<std::remove_const_t<Variables>>::Type;
  static constexpr std::size_t count = detail::SortsOf<std::remove_const_t<Variables>>::count;

  std::conditional_t<std::is_const_v<Variables>, const Scalar, Scalar>* data = nullptr;
  std::size_t stride = 0;
};

/// The variables of one group.
template <typename Variables>
[[nodiscard]] std::remove_const_t<Variables> group_of(const Columns<Variables>& columns,
                                                      std::size_t index) {
  std::remove_const_t<Variables> group;
  for (std::size_t place = 0; place < Columns<Variables>::count; ++place) {
    detail::put_number(&group, place, columns.data[place * columns.stride + index]);
  }
  return group;
}

template <typename Variables>
void put_group(const Columns<Variables>& columns, std::size_t index, const Variables& group) {
  for (std::size_t place = 0; place < Columns<Variables>::count; ++place) {
    columns.data[place * columns.stride + index] =
        detail::number_at<typename Columns<Variables>::Scalar>(&group, place);
  }
}

}  // namespace assur
