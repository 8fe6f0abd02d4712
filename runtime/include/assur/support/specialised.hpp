// Turns a group that an emitted solver holds, whose dimensions are numbers, into a model.
#pragma once

#include <Eigen/LU>
#include <array>
#include <assur/model.hpp>
#include <tuple>
#include <type_traits>
#include <utility>

namespace assur::support {

namespace specialised {

template <typename Group, typename = void>
inline constexpr bool has_inverse = false;
template <typename Group>
inline constexpr bool
    has_inverse<Group, std::void_t<decltype(&Group::template inverse_jacobian<double>)>> = true;

/// What the unknowns are, by the members of a configuration.
template <typename... Members>
[[nodiscard]] constexpr std::array<ModelUnknown, sizeof...(Members)> unknowns_of(
    std::tuple<const Members&...>* /*members*/) {
  return {{{"", std::is_same_v<Members, Direction<double>>, -1}...}};
}

}  // namespace specialised

/// A specialised group with the interface of a model: without dimensions, and its functions with an
/// argument for them that nobody reads. What the group has no function for is computed from what it
/// has.
template <typename Group>
struct Specialised : Group {
  static constexpr bool rigid = true;
  static constexpr int dimension_count = 0;
  static constexpr bool in_any_order = true;
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
  template <typename Scalar, typename... Arguments>
  static void jacobian(const Dimensions<Scalar>& /*d*/, Arguments&&... arguments) {
    Group::jacobian(std::forward<Arguments>(arguments)...);
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
  static void inverse_jacobian(const Dimensions<Scalar>& /*d*/, const Inputs& u,
                               const Configuration& q, Inverse& J_inverse) {
    if constexpr (specialised::has_inverse<Group>) {
      Group::inverse_jacobian(u, q, J_inverse);
    } else {
      Matrix<Scalar, Group::equation_count, Group::unknown_count> J;
      Group::jacobian(u, q, J);
      J_inverse = J.inverse();
    }
  }
};

}  // namespace assur::support
