// Motion of the links and slides of a specialised group with held external joints, and its
// regularity.
#pragma once

#include <algorithm>
#include <assur/detail/index.hpp>
#include <assur/numeric/entries.hpp>
#include <assur/support/derivative_digits.hpp>
#include <assur/support/discriminant.hpp>
#include <assur/support/displacement.hpp>
#include <assur/support/held_group.hpp>
#include <assur/support/second_rates.hpp>
#include <assur/support/specialised.hpp>
#include <limits>

namespace assur::support {

/// The configuration of a group, its regularity, and the reciprocals common to rates and forces.
template <typename Group, typename Scalar>
struct SolvedGroup {
  typename Group::template Configuration<Scalar> q;
  Status regularity = Status::ok;
  Reciprocals<Group, Scalar> reciprocals = numeric::zeros<Reciprocals<Group, Scalar>>();
};

/// The regularity of a configuration whose external joints rounding has displaced.
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

/// Whether the first derivatives of a configuration that is not regular have two correct digits,
/// the displacement by rounding included.
template <typename Group, typename Scalar, int Order, int Parameters>
[[nodiscard, gnu::noinline, gnu::cold]] bool are_derivatives_known(
    const HeldJoints<Group, Scalar, Order, Parameters>& held,
    const typename Group::template Configuration<Scalar>& q) {
  using Model = Specialised<Group>;
  const typename Model::template Dimensions<Scalar> d;
  return DisplacedGroup<Model, Scalar>(d, held.u, held.displaced).regularity(d, held.u, q).error() <
         Scalar(two_digits);
}

/// Whether accelerations of a regular configuration keep its digits for any motion of the inputs.
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

/// The regularity of a configuration in motion, second rates included. Rates with fewer than two
/// correct digits become NaN.
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

/// Whether all external joints of a group are at rest, so that its links are at rest even if it is
/// singular.
template <typename Group, typename Scalar, int Order, int Parameters>
[[nodiscard]] bool is_at_rest(const HeldJoints<Group, Scalar, Order, Parameters>& held) {
  return std::all_of(held.rates.data(), held.rates.data() + Group::input_count * Order,
                     [](const Scalar& rate) { return rate == Scalar(0); });
}

/// Whether the joints' coordinates are so large that their rounding exceeds a few roundings of the
/// group's own lengths.
template <typename Group, typename Scalar>
[[nodiscard]] bool is_small_where_held(const typename Group::template Inputs<Scalar>& u) {
  constexpr Scalar most = 16 * own_length<Group, Scalar>;
  return most < Scalar(most_length_of_numbers) && longest_length(u) > most;
}

/// Places a group's links in a configuration of known regularity. Rates and gradients that do not
/// exist, or have fewer than two correct digits, are NaN.
template <typename Group, typename Scalar, int Order, int Parameters>
[[nodiscard]] PlacedGroup<Group, Scalar, Order, Parameters> place_group(
    const HeldJoints<Group, Scalar, Order, Parameters>& held,
    const typename Group::template Configuration<Scalar>& q, Status regularity) {
  using Model = Specialised<Group>;
  [[maybe_unused]] constexpr Scalar none = std::numeric_limits<Scalar>::quiet_NaN();
  [[maybe_unused]] const typename Model::template Dimensions<Scalar> d;
  PlacedGroup<Group, Scalar, Order, Parameters> placed;
  placed.q = q;
  placed.regularity = regularity;
  // Negligible compared with the rounding that every verdict allows for.
  constexpr Scalar rounding = 16 * std::numeric_limits<Scalar>::epsilon();
  if (held.displaced.moved > rounding * own_length<Group, Scalar> ||
      held.displaced.turned > rounding || is_small_where_held<Group, Scalar>(held.u)) {
    placed.regularity = regularity_among_displaced(held, q, regularity);
  }
  const bool regular = placed.regularity == Status::ok;
  place_links(held, placed);
  if constexpr (Order > 0) {
    auto rates = rates_of_unknowns(held, q);
    if (!regular && is_at_rest(held)) {
      numeric::fill(rates.first, Scalar(0));
      numeric::fill(rates.second, Scalar(0));
    } else if constexpr (Order > 1) {
      if (!regular || !is_firm(held, q)) {
        placed.regularity =
            regularity_in_motion(held, q, placed.regularity, rates.first, rates.second);
      }
    } else if (!regular && !are_derivatives_known(held, q)) {
      numeric::fill(rates.first, none);
    }
    move_links(held, rates, placed);
  }
  if constexpr (Group::link_count > 0 && (Parameters > 0 || Group::holds_groups)) {
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
      differentiate_links(held, J_inverse, placed);
    }
  }
  return placed;
}

}  // namespace assur::support
