// The interface of a model for a group whose dimensions are numbers in an emitted solver.
#pragma once

#include <array>
#include <assur/detail/products.hpp>
#include <assur/model.hpp>
#include <assur/numeric/slope.hpp>
#include <assur/support/scale.hpp>
#include <assur/variables.hpp>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace assur::support {

namespace specialised {

template <typename Group, typename = void>
inline constexpr bool has_inverse = false;
template <typename Group>
inline constexpr bool has_inverse<
    Group, std::void_t<decltype(Group::inverse_jacobian(
               std::declval<const typename Group::template Inputs<double>&>(),
               std::declval<const typename Group::template Configuration<double>&>(),
               std::declval<Matrix<double, Group::unknown_count, Group::equation_count>&>()))>> =
    true;

template <typename Group, typename = void>
inline constexpr bool has_jacobian = false;
template <typename Group>
inline constexpr bool
    has_jacobian<Group, std::void_t<decltype(&Group::template jacobian<double>)>> = true;

/// J = df/dq, column by column, from the residual evaluated in dual numbers.
template <typename Group, typename Scalar>
void differentiate_residual(const typename Group::template Inputs<Scalar>& u,
                            const typename Group::template Configuration<Scalar>& q,
                            Matrix<Scalar, Group::equation_count, Group::unknown_count>& J) {
  using Slope = numeric::Slope<Scalar>;
  const auto held = scaled_to<typename Group::template Inputs<Slope>>(u, 1);
  for (int column = 0; column < Group::unknown_count; ++column) {
    auto moved = scaled_to<typename Group::template Configuration<Slope>>(q, 1);
    for_each_member(moved, [column](auto& member, std::size_t index) {
      if (index != static_cast<std::size_t>(column)) {
        return;
      }
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Slope>) {
        member.slope = 1;
      } else {
        member.cos.slope = -member.sin.value;
        member.sin.slope = member.cos.value;
      }
    });
    Vector<Slope, Group::equation_count> f;
    Group::residual(held, moved, f);
    for (int row = 0; row < Group::equation_count; ++row) {
      J(row, column) = f(row).slope;
    }
  }
}

/// The unknowns, from the members of a configuration.
template <typename... Members>
[[nodiscard]] constexpr std::array<ModelUnknown, sizeof...(Members)> unknowns_of(
    std::tuple<const Members&...>* /*members*/) {
  return {{{"", std::is_same_v<Members, Direction<double>>, -1}...}};
}

/// The second unknown of a group's reduced equations; -1 if there is none.
template <typename Group, typename = void>
inline constexpr int second_unknown = -1;
template <typename Group>
inline constexpr int second_unknown<Group, std::void_t<decltype(Group::second_unknown)>> =
    Group::second_unknown;

}  // namespace specialised

/// A specialised group with the interface of a model. It has no dimensions, so its functions ignore
/// that argument. A matrix for which the group has no function is computed from its other
/// functions.
template <typename Group>
struct Specialised : Group {
  static constexpr bool rigid = true;
  static constexpr int dimension_count = 0;
  static constexpr bool in_any_order = true;
  /// Lengths are numbers, in a unit of the group's own.
  static constexpr int discriminant_degree = 0, leading_degree = 0;
  static constexpr int second_unknown = specialised::second_unknown<Group>;
  static constexpr auto unknowns = specialised::unknowns_of(
      static_cast<decltype(std::declval<const typename Group::template Configuration<double>&>()
                               .members())*>(nullptr));

  template <typename Scalar>
  struct Dimensions {
    [[nodiscard]] auto members() const { return std::tie(); }
  };

  template <typename Scalar, typename... Arguments>
  static void residual(const Dimensions<Scalar>& /*d*/, Arguments&&... arguments) {
    Group::residual(std::forward<Arguments>(arguments)...);
  }
  template <typename Scalar, typename Inputs, typename Configuration, typename Jacobian>
  static void jacobian(const Dimensions<Scalar>& /*d*/, const Inputs& u, const Configuration& q,
                       Jacobian& J) {
    if constexpr (specialised::has_jacobian<Group>) {
      Group::jacobian(u, q, J);
    } else {
      specialised::differentiate_residual<Group, Scalar>(u, q, J);
    }
  }
  template <typename Scalar, typename... Arguments>
  static void degeneracies(const Dimensions<Scalar>& /*d*/, Arguments&&... arguments) {
    Group::degeneracies(std::forward<Arguments>(arguments)...);
  }
  template <typename Scalar, typename... Arguments>
  static void position_polynomial(const Dimensions<Scalar>& /*d*/, Arguments&&... arguments) {
    Group::position_polynomial(std::forward<Arguments>(arguments)...);
  }
  template <typename Scalar, typename... Arguments>
  static void second_equations(const Dimensions<Scalar>& /*d*/, Arguments&&... arguments) {
    Group::second_equations(std::forward<Arguments>(arguments)...);
  }
  template <typename Scalar, typename... Arguments>
  static void complete(const Dimensions<Scalar>& /*d*/, Arguments&&... arguments) {
    Group::complete(std::forward<Arguments>(arguments)...);
  }
  template <typename Scalar, typename Inputs, typename Configuration, typename Inverse>
  static void inverse_jacobian([[maybe_unused]] const Dimensions<Scalar>& d, const Inputs& u,
                               const Configuration& q, Inverse& J_inverse) {
    if constexpr (specialised::has_inverse<Group>) {
      Group::inverse_jacobian(u, q, J_inverse);
    } else {
      Matrix<Scalar, Group::equation_count, Group::unknown_count> J;
      jacobian(d, u, q, J);
      detail::invert(J, J_inverse);
    }
  }
};

}  // namespace assur::support
