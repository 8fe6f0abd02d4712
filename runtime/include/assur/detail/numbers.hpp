// Turns a model's variables into numbers where they stand, one after the other: a loop over their
// members would be compiled anew for every model.
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

/// What the members of variables are, and the numbers that they consist of.
template <typename Members>
struct Sorts;
template <typename... Members>
struct Sorts<std::tuple<const Members&...>> {
  static constexpr std::size_t count = (std::size_t{0} + ... + (sizeof(Members) / sizeof(double)));
  static constexpr std::array<bool, sizeof...(Members)> angles = {
      std::is_same_v<Members, Direction<double>>...};
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

/// Whether none of so many numbers is NaN or infinite.
[[nodiscard]] inline bool are_finite(const void* variables, std::size_t count) {
  bool finite = true;
  for (std::size_t place = 0; place < count; ++place) {
    finite = finite && std::isfinite(number_at<double>(variables, place));
  }
  return finite;
}

/// The largest length by magnitude; zero if there is none.
template <std::size_t Count>
[[nodiscard]] double longest(const void* variables, const std::array<bool, Count>& is_length) {
  double largest = 0;
  for (std::size_t place = 0; place < Count; ++place) {
    if (is_length[place]) {
      largest = (std::max)(largest, std::abs(number_at<double>(variables, place)));
    }
  }
  return largest;
}

/// The largest difference of so many numbers of one and of other variables.
[[nodiscard]] inline double farthest_apart(const void* one, const void* other, std::size_t count) {
  double largest = 0;
  for (std::size_t place = 0; place < count; ++place) {
    largest = (std::max)(largest,
                         std::abs(number_at<double>(one, place) - number_at<double>(other, place)));
  }
  return largest;
}

}  // namespace assur::detail
