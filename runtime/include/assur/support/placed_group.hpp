// Turns a specialised group with held external joints into the motion of its links and slides.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/index.hpp>
#include <assur/numeric/entries.hpp>
#include <assur/support/derivative_digits.hpp>
#include <assur/support/discriminant.hpp>
#include <assur/support/displacement.hpp>
#include <assur/support/placed_link.hpp>
#include <assur/support/second_rates.hpp>
#include <assur/support/specialised.hpp>
#include <limits>

namespace assur::support {

/// The unit of a specialised group, and the longest of its own lengths in that.
template <typename Group, typename Scalar>
inline constexpr Scalar unit_of = static_cast<Scalar>(Group::unit);
template <typename Group, typename Scalar>
inline constexpr Scalar own_length = static_cast<Scalar>(Group::own_length);

/// A slide: its displacement and the first `Order` time derivatives of it.
template <typename Scalar, int Order>
struct Slide {
  Scalar displacement = 0;
  Matrix<Scalar, 1, Order> rates = numeric::zeros<Matrix<Scalar, 1, Order>>();
};

/// Where placed links hold the external joints of a specialised group, and how these move; and the
/// group's dimensions that the solver's parameters or drivers change. Lengths in the group's unit.
template <typename Group, typename Scalar, int Order, int Parameters>
struct HeldJoints {
  typename Group::template Inputs<Scalar> u;
  Matrix<Scalar, Group::input_count, Order> rates;
  Matrix<Scalar, Group::input_count, Parameters> gradient;
  DisplacementOf<Scalar> displaced;  ///< by rounding, the joints, at most

  /// A revolute joint, whose inputs (x, y) stand from `First` on.
  template <int First>
  void hold_point(const Point<Scalar, Order, Parameters>& point) {
    std::get<First>(u.members()) = point.x / unit_of<Group, Scalar>;
    std::get<First + 1>(u.members()) = point.y / unit_of<Group, Scalar>;
    // By entries: compilers keep them in registers then.
    for (int order = 0; order < Order; ++order) {
      rates(First, order) = point.rates(0, order) / unit_of<Group, Scalar>;
      rates(First + 1, order) = point.rates(1, order) / unit_of<Group, Scalar>;
    }
    for (int parameter = 0; parameter < Parameters; ++parameter) {
      gradient(First, parameter) = point.gradient(0, parameter) / unit_of<Group, Scalar>;
      gradient(First + 1, parameter) = point.gradient(1, parameter) / unit_of<Group, Scalar>;
    }
    displaced.moved = (std::max)(displaced.moved, point.displaced.moved / unit_of<Group, Scalar>);
    displaced.reach = (std::max)(displaced.reach, point.displaced.reach / unit_of<Group, Scalar>);
  }
  /// A prismatic joint along the x-axis of a frame, whose inputs (x, y, phi) stand from `First` on.
  template <int First>
  void hold_line(const Frame<Scalar, Order, Parameters>& frame) {
    hold_point<First>(origin_of(frame));
    displaced.turned = (std::max)(displaced.turned, frame.displaced.turned);
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
  /// A length of the group that the solver's parameters or drivers change, whose input stands at
  /// `Place`.
  template <int Place>
  void hold_length(Scalar length,
                   const ParameterRow& of_parameters = numeric::zeros<ParameterRow>(),
                   const RateRow& in_time = numeric::zeros<RateRow>()) {
    std::get<Place>(u.members()) = length / unit_of<Group, Scalar>;
    numeric::set_row(rates, Place, in_time, 1 / unit_of<Group, Scalar>);
    numeric::set_row(gradient, Place, of_parameters, 1 / unit_of<Group, Scalar>);
  }
  /// An angle, likewise.
  template <int Place>
  void hold_angle(const Direction<Scalar>& angle,
                  const ParameterRow& of_parameters = numeric::zeros<ParameterRow>(),
                  const RateRow& in_time = numeric::zeros<RateRow>()) {
    std::get<Place>(u.members()) = angle;
    numeric::set_row(rates, Place, in_time);
    numeric::set_row(gradient, Place, of_parameters);
  }
};

/// One configuration of a specialised group: the normal frames of the links that it places, and the
/// rates of its unknowns.
template <typename Group, typename Scalar, int Order, int Parameters>
struct PlacedGroup {
  typename Group::template Configuration<Scalar> q;
  std::array<Frame<Scalar, Order, Parameters>, detail::size(Group::link_count)> frames;
  std::array<Direction<Scalar>, detail::size(Group::direction_count)> directions;
  Matrix<Scalar, Group::unknown_count, Order> rates;  ///< lengths in the group's unit
  Status regularity = Status::ok;
};

/// The regularity of a configuration where rounding has displaced what holds the group.
template <typename Group, typename Scalar, int Order, int Parameters>
[[nodiscard, gnu::noinline]] Status regularity_among_displaced(
    const HeldJoints<Group, Scalar, Order, Parameters>& held,
    const typename Group::template Configuration<Scalar>& q, Status regularity) {
  using Model = Specialised<Group>;
  const typename Model::template Dimensions<Scalar> d;
  const Status among =
      DisplacedGroup<Model, Scalar>(d, held.u, held.displaced).regularity(d, held.u, q).status;
  return among == Status::ok ? regularity : among;
}

/// Whether the first derivatives of a configuration that is not regular keep two digits, counting
/// what rounding has displaced.
template <typename Group, typename Scalar, int Order, int Parameters>
[[nodiscard, gnu::noinline, gnu::cold]] bool are_derivatives_known(
    const HeldJoints<Group, Scalar, Order, Parameters>& held,
    const typename Group::template Configuration<Scalar>& q) {
  using Model = Specialised<Group>;
  const typename Model::template Dimensions<Scalar> d;
  return DisplacedGroup<Model, Scalar>(d, held.u, held.displaced).regularity(d, held.u, q).error() <
         Scalar(two_digits);
}

/// Whether accelerations of a regular configuration keep its digits whatever moves.
template <typename Group, typename Scalar, int Order, int Parameters>
[[nodiscard]] bool is_firm(const HeldJoints<Group, Scalar, Order, Parameters>& held,
                           const typename Group::template Configuration<Scalar>& q) {
  using Model = Specialised<Group>;
  const typename Model::template Dimensions<Scalar> d;
  const Scalar displaced =
      (std::max)(held.displaced.moved / own_length<Group, Scalar>, held.displaced.turned);
  return detail::is_firm(detail::pivots_at<Model, Scalar>(d, held.u, q),
                         derivative_rounding<Scalar>() + displaced);
}

/// The regularity of a configuration in motion, which counts its second rates. Rates that keep no
/// two digits become NaN.
template <typename Group, typename Scalar, int Order, int Parameters>
[[nodiscard, gnu::noinline, gnu::cold]] Status regularity_in_motion(
    const HeldJoints<Group, Scalar, Order, Parameters>& held,
    const typename Group::template Configuration<Scalar>& q, Status regularity,
    Vector<Scalar, Group::unknown_count>& q_rate,
    Vector<Scalar, Group::unknown_count>& q_second_rate) {
  using Model = Specialised<Group>;
  constexpr Scalar none = std::numeric_limits<Scalar>::quiet_NaN();
  const typename Model::template Dimensions<Scalar> d;
  const auto standing =
      DisplacedGroup<Model, Scalar>(d, held.u, held.displaced).regularity_in_motion(d, held.u, q);
  const Scalar second_error =
      second_rate_error<Model, Scalar>(standing, q_rate, q_second_rate, own_length<Group, Scalar>);
  if (!(standing.error() < Scalar(two_digits))) {
    numeric::fill(q_rate, none);
  }
  if (!(second_error < Scalar(two_digits))) {
    numeric::fill(q_second_rate, none);
  }
  return second_error < Scalar(regular_error<Scalar>) ? regularity : Status::near_singular;
}

/// Whether places are so long beside a group that a rounding of theirs is more than a few of its.
template <typename Group, typename Scalar>
[[nodiscard]] bool is_small_where_held(const typename Group::template Inputs<Scalar>& u) {
  constexpr Scalar most = 16 * own_length<Group, Scalar>;
  return most < Scalar(most_length_of_numbers) && longest_length(u) > most;
}

/// Places a group's links in a configuration of known regularity. Rates and gradients that do not
/// exist, or keep no two digits, are NaN.
template <typename Group, typename Scalar, int Order, int Parameters>
[[nodiscard]] PlacedGroup<Group, Scalar, Order, Parameters> place_group(
    const HeldJoints<Group, Scalar, Order, Parameters>& held,
    const typename Group::template Configuration<Scalar>& q, Status regularity) {
  using Model = Specialised<Group>;
  constexpr int links = Group::link_count;
  constexpr Scalar none = std::numeric_limits<Scalar>::quiet_NaN();
  const typename Model::template Dimensions<Scalar> d;
  PlacedGroup<Group, Scalar, Order, Parameters> placed;
  placed.q = q;
  placed.regularity = regularity;
  // Less is little beside the rounding that every verdict counts.
  constexpr Scalar rounding = 16 * std::numeric_limits<Scalar>::epsilon();
  if (held.displaced.moved > rounding * own_length<Group, Scalar> ||
      held.displaced.turned > rounding || is_small_where_held<Group, Scalar>(held.u)) {
    placed.regularity = regularity_among_displaced(held, q, regularity);
  }
  const bool regular = placed.regularity == Status::ok;
  Poses<Scalar, links + Group::direction_count> poses;
  Group::link_poses(held.u, q, poses);
  for (int link = 0; link < links; ++link) {
    Frame<Scalar, Order, Parameters>& frame = detail::entry(placed.frames, link);
    frame.pose = detail::entry(poses, link);
    frame.pose.x *= unit_of<Group, Scalar>;
    frame.pose.y *= unit_of<Group, Scalar>;
  }
  for (int link = 0; link < Group::direction_count; ++link) {
    detail::entry(placed.directions, link) = detail::entry(poses, links + link).direction;
  }

  if constexpr (Order > 0) {
    auto velocity = numeric::zeros<Matrix<Scalar, links, 3>>();
    Vector<Scalar, Group::unknown_count> q_rate;
    const Vector<Scalar, Group::input_count> u_rate = numeric::column(held.rates, 0);
    if constexpr (Order > 1) {
      const Vector<Scalar, Group::input_count> u_second_rate = numeric::column(held.rates, 1);
      auto acceleration = numeric::zeros<Matrix<Scalar, links, 3>>();
      Vector<Scalar, Group::unknown_count> q_second_rate;
      Group::motion(held.u, q, u_rate, u_second_rate, q_rate, q_second_rate);
      if (!regular || !is_firm(held, q)) {
        placed.regularity = regularity_in_motion(held, q, placed.regularity, q_rate, q_second_rate);
      }
      if constexpr (links > 0) {
        Group::link_accelerations(held.u, q, q_rate, q_second_rate, u_rate, u_second_rate,
                                  acceleration);
      }
      numeric::set_column(placed.rates, 1, q_second_rate);
      for (int link = 0; link < links; ++link) {
        Matrix<Scalar, 3, Order>& rates = detail::entry(placed.frames, link).rates;
        rates(0, 1) = acceleration(link, 0) * unit_of<Group, Scalar>;
        rates(1, 1) = acceleration(link, 1) * unit_of<Group, Scalar>;
        rates(2, 1) = acceleration(link, 2);
      }
    } else {
      Group::velocity(held.u, q, u_rate, q_rate);
      if (!regular && !are_derivatives_known(held, q)) {
        numeric::fill(q_rate, none);
      }
    }
    if constexpr (links > 0) {
      Group::link_velocities(held.u, q, q_rate, u_rate, velocity);
    }
    numeric::set_column(placed.rates, 0, q_rate);
    for (int link = 0; link < links; ++link) {
      Matrix<Scalar, 3, Order>& rates = detail::entry(placed.frames, link).rates;
      rates(0, 0) = velocity(link, 0) * unit_of<Group, Scalar>;
      rates(1, 0) = velocity(link, 1) * unit_of<Group, Scalar>;
      rates(2, 0) = velocity(link, 2);
    }
  }

  if constexpr (links > 0 && (Parameters > 0 || Group::holds_groups)) {
    Matrix<Scalar, Group::unknown_count, Group::equation_count> J_inverse;
    if (is_solvable(placed.regularity)) {
      Model::inverse_jacobian(d, held.u, q, J_inverse);
    } else {
      numeric::fill(J_inverse, none);
    }
    if constexpr (Group::holds_groups) {
      const DisplacedGroup<Model, Scalar> among(d, held.u, held.displaced);
      for (auto& frame : placed.frames) {
        frame.displaced = among.displaced(q, J_inverse).scaled(unit_of<Group, Scalar>);
      }
    }
    if constexpr (Parameters > 0) {
      if (!regular && !are_derivatives_known(held, q)) {
        numeric::fill(J_inverse, none);
      }
      // J q_a = -(F_a + F_u u_a), and p_a = P_a + P_u u_a + P_q q_a.
      Matrix<Scalar, Group::equation_count, Parameters> F_a;
      Matrix<Scalar, Group::equation_count, Group::input_count> F_u;
      Matrix<Scalar, 3 * links, Group::unknown_count> P_q;
      Matrix<Scalar, 3 * links, Parameters> P_a;
      Matrix<Scalar, 3 * links, Group::input_count> P_u;
      Group::parameter_jacobian(held.u, q, F_a);
      Group::input_jacobian(held.u, q, F_u);
      Group::pose_jacobians(held.u, q, P_q, P_a, P_u);
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
  }
  return placed;
}

}  // namespace assur::support
