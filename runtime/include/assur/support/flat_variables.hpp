// A model's variables as an array of numbers of the same type for every model.
#pragma once

#include <array>
#include <assur/model.hpp>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace assur::support {

/// A length is one number, an angle its cosine and sine. No group has more than eight variables of
/// one sort and four external slides.
template <typename Scalar>
using FlatVariables = std::array<Scalar, 24>;

/// The number of numbers in a model's variables. They contain nothing else and are copied bytewise:
/// a loop over their members would be compiled anew for every model.
template <typename Variables, typename Scalar>
inline constexpr std::size_t number_count = std::is_empty_v<Variables>
                                                ? 0
                                                : sizeof(Variables) / sizeof(Scalar);

/// The variables stored in `flat`.
template <typename Variables, typename Scalar, std::size_t Room>
[[nodiscard]] Variables unflattened(const std::array<Scalar, Room>& flat) {
  static_assert(std::is_trivially_copyable_v<Variables>);
  Variables result;
  std::memcpy(static_cast<void*>(&result), flat.data(),
              number_count<Variables, Scalar> * sizeof(Scalar));
  return result;
}

/// The variables stored in `flat` in another scalar; `convert` maps it to that of the variables.
template <typename Variables, typename Scalar, std::size_t Room, typename Convert>
[[nodiscard]] Variables unflattened(const std::array<Scalar, Room>& flat, const Convert& convert) {
  using Own = std::decay_t<decltype(convert(flat[0]))>;
  FlatVariables<Own> converted;
  for (std::size_t place = 0; place < number_count<Variables, Own>; ++place) {
    converted[place] = convert(flat[place]);
  }
  return unflattened<Variables>(converted);
}

/// Stores the variables in `flat` in another scalar.
template <template <typename> class Variables, typename Own, typename Scalar, std::size_t Room>
void flatten(const Variables<Own>& variables, std::array<Scalar, Room>& flat) {
  static_assert(std::is_trivially_copyable_v<Variables<Own>>);
  constexpr std::size_t count = number_count<Variables<Own>, Own>;
  FlatVariables<Own> own;
  std::memcpy(static_cast<void*>(own.data()), &variables, count * sizeof(Own));
  for (std::size_t place = 0; place < count; ++place) {
    flat[place] = Scalar(own[place]);
  }
}

}  // namespace assur::support
