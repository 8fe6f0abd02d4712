// Elementwise operations on a model's variables: steps, largest length, norm and finiteness.
//
// All functions are total: none of them divides, and an input that is not finite makes a result
// that is not finite.
#pragma once

#include <algorithm>
#include <assur/detail/members.hpp>
#include <assur/detail/numbers.hpp>
#include <assur/directions.hpp>
#include <assur/model.hpp>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace assur {

/// Calls `use` with every variable, a length or a Direction, and its index. `Variables` is a
/// model's Dimensions, Inputs or Configuration.
template <typename Variables, typename Use>
constexpr void for_each_member(Variables& variables, Use&& use) {
  detail::visit(variables.members(), use);
}

/// Calls `use` with corresponding variables of two lists: of a model's Dimensions in two scalars,
/// say, or of two configurations.
template <typename One, typename Other, typename Use>
constexpr void for_each_pair(One& one, Other& other, Use&& use) {
  detail::visit_both(one.members(), other.members(), use);
}

/// Adds a step to every variable: lengths grow, angles turn. The step has the variables' order.
template <typename Variables, typename Scalar, int Count>
void advance(Variables& variables, const Vector<Scalar, Count>& step) {
  for_each_member(variables, [&step](auto& member, std::size_t index) {
    detail::advance_member(member, step(static_cast<Eigen::Index>(index)));
  });
}

/// The largest of the lengths and coordinates among variables, by magnitude; zero if there is none.
template <typename Variables>
[[nodiscard]] auto longest_length(const Variables& variables) {
  using Scalar = typename detail::ScalarOf<Variables>::Type;
  return detail::longest<Scalar>(&variables, detail::SortsOf<Variables>::lengths);
}

/// The sum of the squares of the lengths and coordinates among variables.
template <typename Scalar, typename Variables>
[[nodiscard]] Scalar square_of_lengths(const Variables& variables) {
  Scalar sum(0);
  for_each_member(variables, [&sum](const auto& member, std::size_t) {
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Scalar>) {
      sum = sum + member * member;
    }
  });
  return sum;
}

/// Whether no entry is NaN or infinite.
template <typename Scalar, int Count>
[[nodiscard]] bool is_finite(const Vector<Scalar, Count>& vector) {
  for (int index = 0; index < Count; ++index) {
    if (!detail::is_finite_number(vector(index))) {
      return false;
    }
  }
  return true;
}

/// Whether no variable is NaN or infinite.
template <typename Variables>
[[nodiscard]] bool is_finite(const Variables& variables) {
  bool finite = true;
  for_each_member(variables, [&finite](const auto& member, std::size_t) {
    finite = finite && detail::is_finite_number(member);
  });
  return finite;
}
template <template <typename> class Variables, typename Scalar,
          std::enable_if_t<std::is_floating_point_v<Scalar>, int> = 0>
[[nodiscard]] bool is_finite(const Variables<Scalar>& variables) {
  return detail::are_finite<Scalar>(&variables, detail::SortsOf<Variables<Scalar>>::count);
}

}  // namespace assur
