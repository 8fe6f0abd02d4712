// Turns a specialised group with held external joints into the motion of its links and slides.
#pragma once

#include <algorithm>
#include <array>
#include <assur/detail/index.hpp>
#include <assur/support/derivative_digits.hpp>
#include <assur/support/discriminant.hpp>
#include <assur/support/displacement.hpp>
#include <assur/support/placed_link.hpp>
#include <assur/support/specialised.hpp>
#include <limits>

namespace assur::support {

/// A slide: its displacement and the first `Order` time derivatives of it.
template <int Order>
struct Slide {
  double displacement = 0;
  Matrix<double, 1, Order> rates = Matrix<double, 1, Order>::Zero();
};

/// Where placed links hold the external joints of a specialised group, and how these move; and the
/// group's dimensions that the solver's parameters or drivers change. Lengths in the group's unit.
template <typename Group, int Order, int Parameters>
struct HeldJoints {
  typename Group::template Inputs<double> u;
  Matrix<double, Group::input_count, Order> rates;
  Matrix<double, Group::input_count, Parameters> gradient;
  Displacement displaced;  ///< by rounding, the joints, at most

  /// A revolute joint, whose inputs (x, y) stand from `First` on.
  template <int First>
  void hold_point(const Point<double, Order, Parameters>& point) {
    std::get<First>(u.members()) = point.x / Group::unit;
    std::get<First + 1>(u.members()) = point.y / Group::unit;
    // By entries: compilers keep them in registers then.
    for (int order = 0; order < Order; ++order) {
      rates(First, order) = point.rates(0, order) / Group::unit;
      rates(First + 1, order) = point.rates(1, order) / Group::unit;
    }
    gradient.template middleRows<2>(First) = point.gradient / Group::unit;
    displaced.moved = (std::max)(displaced.moved, point.displaced.moved / Group::unit);
    displaced.reach = (std::max)(displaced.reach, point.displaced.reach / Group::unit);
  }
  /// A prismatic joint along the x-axis of a frame, whose inputs (x, y, phi) stand from `First` on.
  template <int First>
  void hold_line(const Frame<double, Order, Parameters>& frame) {
    hold_point<First>({frame.pose.x, frame.pose.y, frame.rates.template topRows<2>(),
                       frame.gradient.template topRows<2>(), frame.displaced});
    displaced.turned = (std::max)(displaced.turned, frame.displaced.turned);
    std::get<First + 2>(u.members()) = frame.pose.direction;
    rates.row(First + 2) = frame.rates.row(2);
    gradient.row(First + 2) = frame.gradient.row(2);
  }
  using ParameterRow = Matrix<double, 1, Parameters>;
  using RateRow = Matrix<double, 1, Order>;
  /// A length of the group that the solver's parameters or drivers change, whose input stands at
  /// `Place`.
  template <int Place>
  void hold_length(double length, const ParameterRow& of_parameters = ParameterRow::Zero(),
                   const RateRow& in_time = RateRow::Zero()) {
    std::get<Place>(u.members()) = length / Group::unit;
    rates.row(Place) = in_time / Group::unit;
    gradient.row(Place) = of_parameters / Group::unit;
  }
  /// An angle, likewise.
  template <int Place>
  void hold_angle(const Direction<double>& angle,
                  const ParameterRow& of_parameters = ParameterRow::Zero(),
                  const RateRow& in_time = RateRow::Zero()) {
    std::get<Place>(u.members()) = angle;
    rates.row(Place) = in_time;
    gradient.row(Place) = of_parameters;
  }
};

/// One configuration of a specialised group: the normal frames of the links that it places, and the
/// rates of its unknowns.
template <typename Group, int Order, int Parameters>
struct PlacedGroup {
  typename Group::template Configuration<double> q;
  std::array<Frame<double, Order, Parameters>, detail::size(Group::link_count)> frames;
  std::array<Direction<double>, detail::size(Group::direction_count)> directions;
  Matrix<double, Group::unknown_count, Order> rates;  ///< lengths in the group's unit
  Status regularity = Status::ok;
};

/// The regularity of a configuration where rounding has displaced what holds the group.
template <typename Group, int Order, int Parameters>
[[nodiscard, gnu::noinline]] Status regularity_among_displaced(
    const HeldJoints<Group, Order, Parameters>& held,
    const typename Group::template Configuration<double>& q, Status regularity) {
  using Model = Specialised<Group>;
  const typename Model::template Dimensions<double> d;
  const Status among =
      DisplacedGroup<Model>(d, held.u, held.displaced).regularity(d, held.u, q).status;
  return among == Status::ok ? regularity : among;
}

/// The derivatives of a configuration that is not regular, counting what rounding has displaced.
template <typename Group, int Order, int Parameters>
[[nodiscard, gnu::noinline, gnu::cold]] KnownDerivatives derivatives_among_displaced(
    const HeldJoints<Group, Order, Parameters>& held,
    const typename Group::template Configuration<double>& q) {
  using Model = Specialised<Group>;
  const typename Model::template Dimensions<double> d;
  return known_derivatives(
      DisplacedGroup<Model>(d, held.u, held.displaced).regularity(d, held.u, q));
}

/// Whether places are so long beside a group that a rounding of theirs is more than a few of its.
template <typename Group>
[[nodiscard]] bool is_small_where_held(const typename Group::template Inputs<double>& u) {
  constexpr double most = 16 * Group::own_length;
  return most < most_length_of_numbers && longest_length(u) > most;
}

/// Places a group's links in a configuration of known regularity. Rates and gradients that do not
/// exist, or keep no two digits, are NaN.
template <typename Group, int Order, int Parameters>
[[nodiscard]] PlacedGroup<Group, Order, Parameters> place_group(
    const HeldJoints<Group, Order, Parameters>& held,
    const typename Group::template Configuration<double>& q, Status regularity) {
  using Model = Specialised<Group>;
  constexpr int links = Group::link_count;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const typename Model::template Dimensions<double> d;
  PlacedGroup<Group, Order, Parameters> placed;
  placed.q = q;
  placed.regularity = regularity;
  // Less is little beside the rounding that every verdict counts.
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  if (held.displaced.moved > rounding * Group::own_length || held.displaced.turned > rounding ||
      is_small_where_held<Group>(held.u)) {
    placed.regularity = regularity_among_displaced(held, q, regularity);
  }
  const bool regular = placed.regularity == Status::ok;
  Poses<double, links + Group::direction_count> poses;
  Group::link_poses(held.u, q, poses);
  for (int link = 0; link < links; ++link) {
    Frame<double, Order, Parameters>& frame = detail::entry(placed.frames, link);
    frame.pose = detail::entry(poses, link);
    frame.pose.x *= Group::unit;
    frame.pose.y *= Group::unit;
  }
  for (int link = 0; link < Group::direction_count; ++link) {
    detail::entry(placed.directions, link) = detail::entry(poses, links + link).direction;
  }

  if constexpr (Order > 0) {
    Matrix<double, links, 3> velocity = Matrix<double, links, 3>::Zero();
    Vector<double, Group::unknown_count> q_rate;
    const Vector<double, Group::input_count> u_rate = held.rates.col(0);
    if constexpr (Order > 1) {
      const Vector<double, Group::input_count> u_second_rate = held.rates.col(1);
      Matrix<double, links, 3> acceleration = Matrix<double, links, 3>::Zero();
      Vector<double, Group::unknown_count> q_second_rate;
      Group::motion(held.u, q, u_rate, u_second_rate, q_rate, q_second_rate);
      if (!regular) {
        const KnownDerivatives known = derivatives_among_displaced(held, q);
        if (!known.rates) {
          q_rate.setConstant(none);
        }
        if (!known.second_rates) {
          q_second_rate.setConstant(none);
        }
      }
      if constexpr (links > 0) {
        Group::link_accelerations(held.u, q, q_rate, q_second_rate, u_rate, u_second_rate,
                                  acceleration);
      }
      placed.rates.col(1) = q_second_rate;
      for (int link = 0; link < links; ++link) {
        Matrix<double, 3, Order>& rates = detail::entry(placed.frames, link).rates;
        rates(0, 1) = acceleration(link, 0) * Group::unit;
        rates(1, 1) = acceleration(link, 1) * Group::unit;
        rates(2, 1) = acceleration(link, 2);
      }
    } else {
      Group::velocity(held.u, q, u_rate, q_rate);
      if (!regular && !derivatives_among_displaced(held, q).rates) {
        q_rate.setConstant(none);
      }
    }
    if constexpr (links > 0) {
      Group::link_velocities(held.u, q, q_rate, u_rate, velocity);
    }
    placed.rates.col(0) = q_rate;
    for (int link = 0; link < links; ++link) {
      Matrix<double, 3, Order>& rates = detail::entry(placed.frames, link).rates;
      rates(0, 0) = velocity(link, 0) * Group::unit;
      rates(1, 0) = velocity(link, 1) * Group::unit;
      rates(2, 0) = velocity(link, 2);
    }
  }

  if constexpr (links > 0 && (Parameters > 0 || Group::holds_groups)) {
    Matrix<double, Group::unknown_count, Group::equation_count> J_inverse;
    if (is_solvable(placed.regularity)) {
      Model::inverse_jacobian(d, held.u, q, J_inverse);
    } else {
      J_inverse.setConstant(none);
    }
    if constexpr (Group::holds_groups) {
      const DisplacedGroup<Model> among(d, held.u, held.displaced);
      for (auto& frame : placed.frames) {
        frame.displaced = among.displaced(q, J_inverse).scaled(Group::unit);
      }
    }
    if constexpr (Parameters > 0) {
      if (!regular && !derivatives_among_displaced(held, q).rates) {
        J_inverse.setConstant(none);
      }
      // J q_a = -(F_a + F_u u_a), and p_a = P_a + P_u u_a + P_q q_a.
      Matrix<double, Group::equation_count, Parameters> F_a;
      Matrix<double, Group::equation_count, Group::input_count> F_u;
      Matrix<double, 3 * links, Group::unknown_count> P_q;
      Matrix<double, 3 * links, Parameters> P_a;
      Matrix<double, 3 * links, Group::input_count> P_u;
      Group::parameter_jacobian(held.u, q, F_a);
      Group::input_jacobian(held.u, q, F_u);
      Group::pose_jacobians(held.u, q, P_q, P_a, P_u);
      // Products of a few rows and columns do not pay for Eigen's blocks of large ones.
      const Matrix<double, Group::equation_count, Parameters> rhs =
          F_a + F_u.lazyProduct(held.gradient);
      const Matrix<double, Group::unknown_count, Parameters> q_a = J_inverse.lazyProduct(rhs);
      const Matrix<double, 3 * links, Parameters> gradient =
          P_a + P_u.lazyProduct(held.gradient) - P_q.lazyProduct(q_a);
      for (int link = 0; link < links; ++link) {
        Frame<double, Order, Parameters>& frame = detail::entry(placed.frames, link);
        frame.gradient = gradient.template middleRows<3>(3 * link);
        frame.gradient.template topRows<2>() *= Group::unit;
      }
    }
  }
  return placed;
}

}  // namespace assur::support
