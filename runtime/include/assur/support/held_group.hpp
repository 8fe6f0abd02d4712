// Motion of the links of a specialised group with held external joints, in a known configuration;
// for several groups at once if the scalar is a pack.
#pragma once

#include <array>
#include <assur/detail/index.hpp>
#include <assur/numeric/entries.hpp>
#include <assur/status.hpp>
#include <assur/support/placed_link.hpp>
#include <assur/support/specialised.hpp>
#include <type_traits>

namespace assur::support {

/// The unit of a specialised group, and the longest of its own lengths in this unit.
template <typename Group, typename Scalar>
inline constexpr auto unit_of = static_cast<typename numeric::PartOf<Scalar>::Type>(Group::unit);
template <typename Group, typename Scalar>
inline constexpr auto own_length =
    static_cast<typename numeric::PartOf<Scalar>::Type>(Group::own_length);

/// The number of reciprocals that a group's rates and forces share.
template <typename Group, typename = void>
inline constexpr int reciprocal_count = 0;
template <typename Group>
inline constexpr int reciprocal_count<Group, std::void_t<decltype(Group::reciprocal_count)>> =
    Group::reciprocal_count;
template <typename Group, typename Scalar>
using Reciprocals = Vector<Scalar, reciprocal_count<Group>>;

/// A slide: its displacement and the first `Order` time derivatives of the displacement.
template <typename Scalar, int Order>
struct Slide {
  Scalar displacement = 0;
  Matrix<Scalar, 1, Order> rates = numeric::zeros<Matrix<Scalar, 1, Order>>();
};

/// Positions and rates of the external joints of a specialised group, which placed links hold, and
/// the group's dimensions that the solver's parameters or drivers change. Lengths in the group's
/// unit.
template <typename Group, typename Scalar, int Order, int Parameters>
struct HeldJoints {
  typename Group::template Inputs<Scalar> u;
  Matrix<Scalar, Group::input_count, Order> rates;
  Matrix<Scalar, Group::input_count, Parameters> gradient;
  DisplacementOf<Scalar> displaced;  ///< bound on the joints' displacement by rounding

  /// Holds a revolute joint, whose inputs (x, y) begin at `First`.
  template <int First>
  void hold_point(const Point<Scalar, Order, Parameters>& point) {
    std::get<First>(u.members()) = point.x / unit_of<Group, Scalar>;
    std::get<First + 1>(u.members()) = point.y / unit_of<Group, Scalar>;
    // Entries are added one by one, so that compilers keep them in registers.
    for (int order = 0; order < Order; ++order) {
      rates(First, order) = point.rates(0, order) / unit_of<Group, Scalar>;
      rates(First + 1, order) = point.rates(1, order) / unit_of<Group, Scalar>;
    }
    for (int parameter = 0; parameter < Parameters; ++parameter) {
      gradient(First, parameter) = point.gradient(0, parameter) / unit_of<Group, Scalar>;
      gradient(First + 1, parameter) = point.gradient(1, parameter) / unit_of<Group, Scalar>;
    }
    displaced.moved = larger(displaced.moved, point.displaced.moved / unit_of<Group, Scalar>);
    displaced.reach = larger(displaced.reach, point.displaced.reach / unit_of<Group, Scalar>);
  }
  /// Holds a prismatic joint along the x-axis of a frame, whose inputs (x, y, phi) begin at
  /// `First`.
  template <int First>
  void hold_line(const Frame<Scalar, Order, Parameters>& frame) {
    hold_point<First>(origin_of(frame));
    displaced.turned = larger(displaced.turned, frame.displaced.turned);
    std::get<First + 2>(u.members()) = frame.pose.direction;
    for (int order = 0; order < Order; ++order) {
      rates(First + 2, order) = frame.rates(2, order);
    }
    for (int parameter = 0; parameter < Parameters; ++parameter) {
      gradient(First + 2, parameter) = frame.gradient(2, parameter);
    }
  }
  using ParameterRow = Matrix<Scalar, 1, Parameters>;
  using RateRow = Matrix<Scalar, 1, Order>;
  /// Holds a length of the group that the solver's parameters or drivers change, whose input is at
  /// `Place`.
  template <int Place>
  void hold_length(Scalar length,
                   const ParameterRow& of_parameters = numeric::zeros<ParameterRow>(),
                   const RateRow& in_time = numeric::zeros<RateRow>()) {
    std::get<Place>(u.members()) = length / unit_of<Group, Scalar>;
    numeric::set_row(rates, Place, in_time, Scalar(1 / unit_of<Group, Scalar>));
    numeric::set_row(gradient, Place, of_parameters, Scalar(1 / unit_of<Group, Scalar>));
  }
  /// Holds an angle in the same way.
  template <int Place>
  void hold_angle(const Direction<Scalar>& angle,
                  const ParameterRow& of_parameters = numeric::zeros<ParameterRow>(),
                  const RateRow& in_time = numeric::zeros<RateRow>()) {
    std::get<Place>(u.members()) = angle;
    numeric::set_row(rates, Place, in_time);
    numeric::set_row(gradient, Place, of_parameters);
  }
};

/// One configuration of a specialised group: the normal frames of its links, and the rates of its
/// unknowns.
template <typename Group, typename Scalar, int Order, int Parameters>
struct PlacedGroup {
  typename Group::template Configuration<Scalar> q;
  std::array<Frame<Scalar, Order, Parameters>, detail::size(Group::link_count)> frames;
  std::array<Direction<Scalar>, detail::size(Group::direction_count)> directions;
  Matrix<Scalar, Group::unknown_count, Order> rates;  ///< lengths in the group's unit
  Reciprocals<Group, Scalar> reciprocals = numeric::zeros<Reciprocals<Group, Scalar>>();
  Status regularity = Status::ok;
};

/// The rates of a group's unknowns.
template <typename Group, typename Scalar>
struct UnknownRates {
  Vector<Scalar, Group::unknown_count> first;
  Vector<Scalar, Group::unknown_count> second;  ///< set where accelerations are modelled
  Reciprocals<Group, Scalar> reciprocals;       ///< also used for the group's forces
};
template <typename Group, typename Scalar, int Order, int Parameters>
[[nodiscard]] UnknownRates<Group, Scalar> rates_of_unknowns(
    const HeldJoints<Group, Scalar, Order, Parameters>& held,
    const typename Group::template Configuration<Scalar>& q) {
  UnknownRates<Group, Scalar> rates;
  const Vector<Scalar, Group::input_count> u_rate = numeric::column(held.rates, 0);
  const auto find = [&](auto&... reciprocals) {
    if constexpr (Order > 1) {
      const Vector<Scalar, Group::input_count> u_second_rate = numeric::column(held.rates, 1);
      Group::motion(held.u, q, u_rate, u_second_rate, rates.first, rates.second, reciprocals...);
    } else {
      Group::velocity(held.u, q, u_rate, rates.first, reciprocals...);
    }
  };
  if constexpr (reciprocal_count < Group >> 0) {
    find(rates.reciprocals);
  } else {
    find();
  }
  return rates;
}

/// Sets the poses of the links.
template <typename Group, typename Scalar, int Order, int Parameters>
void place_links(const HeldJoints<Group, Scalar, Order, Parameters>& held,
                 PlacedGroup<Group, Scalar, Order, Parameters>& placed) {
  constexpr int links = Group::link_count;
  Poses<Scalar, links + Group::direction_count> poses;
  Group::link_poses(held.u, placed.q, poses);
  for (int link = 0; link < links; ++link) {
    Frame<Scalar, Order, Parameters>& frame = detail::entry(placed.frames, link);
    frame.pose = detail::entry(poses, link);
    frame.pose.x *= unit_of<Group, Scalar>;
    frame.pose.y *= unit_of<Group, Scalar>;
  }
  for (int link = 0; link < Group::direction_count; ++link) {
    detail::entry(placed.directions, link) = detail::entry(poses, links + link).direction;
  }
}

/// Sets the motion of the links, from the rates of the unknowns.
template <typename Group, typename Scalar, int Order, int Parameters>
void move_links(const HeldJoints<Group, Scalar, Order, Parameters>& held,
                const UnknownRates<Group, Scalar>& q_rates,
                PlacedGroup<Group, Scalar, Order, Parameters>& placed) {
  constexpr int links = Group::link_count;
  placed.reciprocals = q_rates.reciprocals;
  const Vector<Scalar, Group::input_count> u_rate = numeric::column(held.rates, 0);
  if constexpr (Order > 1) {
    auto acceleration = numeric::zeros<Matrix<Scalar, links, 3>>();
    if constexpr (links > 0) {
      const Vector<Scalar, Group::input_count> u_second_rate = numeric::column(held.rates, 1);
      Group::link_accelerations(held.u, placed.q, q_rates.first, q_rates.second, u_rate,
                                u_second_rate, acceleration);
    }
    numeric::set_column(placed.rates, 1, q_rates.second);
    for (int link = 0; link < links; ++link) {
      Matrix<Scalar, 3, Order>& rates = detail::entry(placed.frames, link).rates;
      rates(0, 1) = acceleration(link, 0) * unit_of<Group, Scalar>;
      rates(1, 1) = acceleration(link, 1) * unit_of<Group, Scalar>;
      rates(2, 1) = acceleration(link, 2);
    }
  }
  auto velocity = numeric::zeros<Matrix<Scalar, links, 3>>();
  if constexpr (links > 0) {
    Group::link_velocities(held.u, placed.q, q_rates.first, u_rate, velocity);
  }
  numeric::set_column(placed.rates, 0, q_rates.first);
  for (int link = 0; link < links; ++link) {
    Matrix<Scalar, 3, Order>& rates = detail::entry(placed.frames, link).rates;
    rates(0, 0) = velocity(link, 0) * unit_of<Group, Scalar>;
    rates(1, 0) = velocity(link, 1) * unit_of<Group, Scalar>;
    rates(2, 0) = velocity(link, 2);
  }
}

/// Sets the derivatives of the links' frames with respect to the parameters, by J^-1: J q_a = -(F_a
/// + F_u u_a), and p_a = P_a + P_u u_a + P_q q_a.
template <typename Group, typename Scalar, int Order, int Parameters>
void differentiate_links(
    const HeldJoints<Group, Scalar, Order, Parameters>& held,
    const Matrix<Scalar, Group::unknown_count, Group::equation_count>& J_inverse,
    PlacedGroup<Group, Scalar, Order, Parameters>& placed) {
  constexpr int links = Group::link_count;
  Matrix<Scalar, Group::equation_count, Parameters> F_a;
  Matrix<Scalar, Group::equation_count, Group::input_count> F_u;
  Matrix<Scalar, 3 * links, Group::unknown_count> P_q;
  Matrix<Scalar, 3 * links, Parameters> P_a;
  Matrix<Scalar, 3 * links, Group::input_count> P_u;
  Group::parameter_jacobian(held.u, placed.q, F_a);
  Group::input_jacobian(held.u, placed.q, F_u);
  Group::pose_jacobians(held.u, placed.q, P_q, P_a, P_u);
  auto q_a = numeric::zeros<Matrix<Scalar, Group::unknown_count, Parameters>>();
  numeric::add_product(F_a, F_u, held.gradient);
  numeric::add_product<-1>(q_a, J_inverse, F_a);
  numeric::add_product(P_a, P_u, held.gradient);
  numeric::add_product(P_a, P_q, q_a);
  for (int link = 0; link < links; ++link) {
    Matrix<Scalar, 3, Parameters>& gradient = detail::entry(placed.frames, link).gradient;
    for (int parameter = 0; parameter < Parameters; ++parameter) {
      gradient(0, parameter) = P_a(3 * link, parameter) * unit_of<Group, Scalar>;
      gradient(1, parameter) = P_a(3 * link + 1, parameter) * unit_of<Group, Scalar>;
      gradient(2, parameter) = P_a(3 * link + 2, parameter);
    }
  }
}

}  // namespace assur::support
