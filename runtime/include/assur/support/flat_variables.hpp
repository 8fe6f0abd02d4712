// Turns a model's variables into numbers one after the other, and back: the same for every model.
#pragma once

#include <array>
#include <assur/model.hpp>
#include <assur/variables.hpp>
#include <cstddef>
#include <type_traits>

namespace assur::support {

/// A length is one number, an angle its cosine and sine. No group has more than eight variables of
/// a sort and four external slides.
template <typename Scalar>
using FlatVariables = std::array<Scalar, 24>;

/// The variables that stand in `flat`; `convert` turns its numbers into theirs.
template <typename Variables, typename Flat, typename Convert>
[[nodiscard]] Variables unflattened(const Flat& flat, const Convert& convert) {
  Variables result;
  std::size_t place = 0;
  for_each_member(result, [&](auto& member, std::size_t) {
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>,
                                 std::decay_t<decltype(convert(flat[0]))>>) {
      member = convert(flat[place++]);
    } else {
      member.cos = convert(flat[place++]);
      member.sin = convert(flat[place++]);
    }
  });
  return result;
}

/// The variables as `flat` numbers of another scalar.
template <typename Variables, typename Flat>
void flatten(const Variables& variables, Flat& flat) {
  using Scalar = std::decay_t<decltype(flat[0])>;
  std::size_t place = 0;
  for_each_member(variables, [&](const auto& member, std::size_t) {
    if constexpr (std::is_constructible_v<Scalar, std::decay_t<decltype(member)>>) {
      flat[place++] = Scalar(member);
    } else {
      flat[place++] = Scalar(member.cos);
      flat[place++] = Scalar(member.sin);
    }
  });
}

}  // namespace assur::support
