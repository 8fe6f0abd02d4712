// Loads of packs from columns of numbers, and stores to columns.
#pragma once

#include <assur/columns.hpp>
#include <assur/detail/index.hpp>
#include <assur/variables.hpp>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace assur::detail::batch {

/// Calls `use` with 0, 1, ..., without a loop: compilers keep packs in registers if no index is a
/// variable.
template <typename Use, std::size_t... Place>
[[gnu::always_inline]] inline void for_each_place(const Use& use, std::index_sequence<Place...>) {
  (use(Place), ...);
}
template <int Count, typename Use>
[[gnu::always_inline]] inline void for_each_place(const Use& use) {
  for_each_place(use, std::make_index_sequence<size(Count)>());
}

/// Calls `use` with every number of variables and its index; a direction is two numbers, its cosine
/// and its sine.
template <typename Variables, typename Use>
[[gnu::always_inline]] inline void for_each_number(Variables& variables, Use use) {
  std::size_t place = 0;
  for_each_member(variables, [&](auto& member, std::size_t) {
    if constexpr (is_direction<std::decay_t<decltype(member)>>) {
      use(member.cos, place++);
      use(member.sin, place++);
    } else {
      use(member, place++);
    }
  });
}

/// The variables of the groups from `first` on.
template <typename Packed, typename Variables>
[[nodiscard, gnu::always_inline]] inline Packed load_groups(const Columns<Variables>& columns,
                                                            std::size_t first) {
  Packed packed;
  for_each_number(packed, [&](auto& number, std::size_t place) {
    number = std::decay_t<decltype(number)>::load(columns.data + place * columns.stride + first);
  });
  return packed;
}

template <typename Packed, typename Variables>
[[gnu::always_inline]] inline void store_groups(const Packed& packed,
                                                const Columns<Variables>& columns,
                                                std::size_t first) {
  for_each_number(packed, [&](const auto& number, std::size_t place) {
    number.store(columns.data + place * columns.stride + first);
  });
}

/// The variables of one lane, in another scalar if need be.
template <typename One, typename Packed>
[[nodiscard]] One group_in_lane(const Packed& packed, std::size_t lane) {
  One group;
  for_each_number(packed, [&](const auto& number, std::size_t place) {
    put_number(&group, place, typename ScalarOf<One>::Type(number[lane]));
  });
  return group;
}

/// Exchanges two lists of variables in the lanes in which `holds` is true.
template <typename Truth, typename Packed>
[[gnu::always_inline]] inline void exchange_where(const Truth& holds, Packed& one, Packed& other) {
  const auto exchange = [&holds](auto& first, auto& second) {
    const auto kept = first;
    first = select(holds, second, first);
    second = select(holds, kept, second);
  };
  for_each_pair(one, other, [&exchange](auto& first, auto& second) {
    if constexpr (is_direction<std::decay_t<decltype(first)>>) {
      exchange(first.cos, second.cos);
      exchange(first.sin, second.sin);
    } else {
      exchange(first, second);
    }
  });
}

}  // namespace assur::detail::batch
