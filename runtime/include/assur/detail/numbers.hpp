// A model's variables as the numbers of which they consist in memory: a loop over their members
// would be compiled anew for every model.
#pragma once

#include <algorithm>
#include <array>
#include <assur/model.hpp>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <tuple>
#include <type_traits>
#include <utility>

namespace assur::detail {

/// The scalar of a model's variables.
template <typename Variables>
struct ScalarOf;
template <template <typename> class Variables, typename Scalar>
struct ScalarOf<Variables<Scalar>> {
  using Type = Scalar;
};

template <typename Member>
inline constexpr bool is_direction = false;
template <typename Scalar>
inline constexpr bool is_direction<Direction<Scalar>> = true;

/// The sorts of the members of variables, and of the numbers in them.
template <typename Members>
struct Sorts;
template <typename... Members>
struct Sorts<std::tuple<const Members&...>> {
  static constexpr std::size_t count =
      (std::size_t{0} + ... + std::size_t{is_direction<Members> ? 2 : 1});
  static constexpr std::array<bool, sizeof...(Members)> angles = {is_direction<Members>...};
  static constexpr std::array<bool, count> lengths = [] {
    std::array<bool, count> result{};
    std::size_t place = 0;
    for (const bool is_angle : angles) {
      if (!is_angle) {
        result[place] = true;
      }
      place += is_angle ? 2 : 1;
    }
    return result;
  }();
};
template <typename Variables>
using SortsOf = Sorts<decltype(std::declval<const Variables&>().members())>;

template <typename Scalar>
[[nodiscard]] Scalar number_at(const void* variables, std::size_t place) {
  Scalar number;
  std::memcpy(static_cast<void*>(&number),
              static_cast<const std::byte*>(variables) + place * sizeof(Scalar), sizeof(Scalar));
  return number;
}

template <typename Scalar>
void put_number(void* variables, std::size_t place, const Scalar& number) {
  static_assert(std::is_trivially_copyable_v<Scalar>);
  std::memcpy(static_cast<std::byte*>(variables) + place * sizeof(Scalar), &number, sizeof(Scalar));
}

/// Whether none of `count` numbers is NaN or infinite.
template <typename Scalar>
[[nodiscard]] bool are_finite(const void* variables, std::size_t count) {
  bool finite = true;
  for (std::size_t place = 0; place < count; ++place) {
    finite = finite && std::isfinite(number_at<Scalar>(variables, place));
  }
  return finite;
}

/// The largest length by magnitude; zero if there is none.
template <typename Scalar, std::size_t Count>
[[nodiscard]] Scalar longest(const void* variables, const std::array<bool, Count>& is_length) {
  Scalar largest = 0;
  for (std::size_t place = 0; place < Count; ++place) {
    if (is_length[place]) {
      largest = (std::max)(largest, std::abs(number_at<Scalar>(variables, place)));
    }
  }
  return largest;
}

/// The largest difference of `count` numbers of two lists of variables.
template <typename Scalar>
[[nodiscard]] Scalar farthest_apart(const void* one, const void* other, std::size_t count) {
  Scalar largest = 0;
  for (std::size_t place = 0; place < count; ++place) {
    largest = (std::max)(largest,
                         std::abs(number_at<Scalar>(one, place) - number_at<Scalar>(other, place)));
  }
  return largest;
}

}  // namespace assur::detail
