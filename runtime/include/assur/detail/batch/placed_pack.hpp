// Motion of the links of several specialised groups with held external joints, and the lanes in
// which all digits are certain.
#pragma once

#include <assur/detail/batch/pack_verdicts.hpp>
#include <assur/detail/pivots.hpp>
#include <assur/numeric/magnitude.hpp>
#include <assur/support/discriminant.hpp>
#include <assur/support/held_group.hpp>
#include <assur/support/scale.hpp>
#include <assur/support/specialised.hpp>
#include <limits>

namespace assur::detail::batch {

/// Held groups whose inputs rounding has displaced, for the search by formula.
template <typename Model, typename Pack>
struct DisplacedInputs {
  using Scalar = typename numeric::PartOf<Pack>::Type;
  support::DisplacementOf<Pack> displaced;

  /// The error of a discriminant, as in `Certainty::error` for one group.
  template <typename Certainty>
  [[nodiscard]] Pack error(const Certainty& certainty, const Pack& square) const {
    constexpr auto given = static_cast<Scalar>(numeric::Magnitude::given_rounding());
    const Pack part = displaced.moved / sqrt(square) + displaced.turned;
    return certainty.power(square) * (Pack(1) + part * Pack(1 / given));
  }
  /// The error of the Jacobian, as in `unsure_jacobian` for one group.
  [[nodiscard]] Pack unsure(const typename Model::template Dimensions<Pack>& /*d*/,
                            const typename Model::template Inputs<Pack>& u, const Pack& /*square*/,
                            const Pack& /*of_dimensions*/) const {
    return unsure(u);
  }
  [[nodiscard]] Pack unsure(const typename Model::template Inputs<Pack>& u) const {
    const Pack epsilon(std::numeric_limits<Scalar>::epsilon());
    if constexpr (has_angles<Model>) {
      const Pack moved = support::larger(displaced.moved, epsilon * longest_lengths(u));
      return support::larger(moved * Pack(1 / Model::own_length), displaced.turned);
    } else {
      return support::larger(epsilon, displaced.turned);
    }
  }

  /// Bounds on the displacement of the groups' own links, as in `DisplacedGroup::displaced` for one
  /// group; lengths are near one.
  template <typename Configuration, typename Inverse>
  [[nodiscard]] support::DisplacementOf<Pack> of_links(
      const typename Model::template Inputs<Pack>& u, const Configuration& q,
      const Inverse& J_inverse) const {
    const Pack epsilon(std::numeric_limits<Scalar>::epsilon());
    const Pack one(1);
    Pack largest(0);
    Pack turn(0);
    for (int row = 0; row < Model::unknown_count; ++row) {
      Pack sum(0);
      for (int column = 0; column < Model::equation_count; ++column) {
        sum = sum + abs(J_inverse(row, column));
      }
      largest = support::larger(largest, sum);
      turn = is_angle<Model>(row) ? support::larger(turn, sum) : turn;
    }
    const Pack moved = displaced.moved + epsilon * longest_lengths(u);
    const Pack open =
        Pack(2) * (moved + displaced.turned * support::larger(one, longest_lengths(q))) + epsilon;
    const Pack turned = displaced.turned + epsilon + turn * open;
    const Pack half_turn(3.14159265358979);
    return {moved + largest * open, select(turned < half_turn, turned, half_turn),
            support::larger(displaced.reach, one), one};
  }
};

/// The groups' links in configurations that are regular by themselves, as `place_group` places
/// them.
template <typename Group, typename Pack, int Order, int Parameters>
struct PlacedPack {
  using Model = support::Specialised<Group>;
  using Truth = decltype(Pack() < Pack());
  support::PlacedGroup<Group, Pack, Order, Parameters> group;
  /// The lanes that keep every digit despite the displacement by rounding.
  Truth certain;

  PlacedPack(const support::HeldJoints<Group, Pack, Order, Parameters>& held,
             const typename Group::template Configuration<Pack>& q) {
    const typename Model::template Dimensions<Pack> d;
    const DisplacedInputs<Model, Pack> rounding{held.displaced};
    group.q = q;
    certain = is_regular_among_displaced(held, rounding);
    support::place_links(held, group);
    if constexpr (Order > 0) {
      support::move_links(held, support::rates_of_unknowns(held, q), group);
    }
    if constexpr (Order > 1) {
      constexpr Scalar own = support::own_length<Group, Pack>;
      const Pack displaced =
          support::larger(held.displaced.moved * Pack(1 / own), held.displaced.turned);
      certain = certain & is_firm(pivots_at<Model, Pack>(d, held.u, q),
                                  Pack(closer) * (Pack(derivative_rounding<Scalar>()) + displaced));
    }
    if constexpr (Group::link_count > 0 && (Parameters > 0 || Group::holds_groups)) {
      Matrix<Pack, Group::unknown_count, Group::equation_count> J_inverse;
      Model::inverse_jacobian(d, held.u, q, J_inverse);
      if constexpr (Group::holds_groups) {
        const auto displaced =
            rounding.of_links(held.u, q, J_inverse).scaled(Pack(support::unit_of<Group, Pack>));
        for (auto& frame : group.frames) {
          frame.displaced = displaced;
        }
      }
      if constexpr (Parameters > 0) {
        support::differentiate_links(held, J_inverse, group);
      }
    }
  }

 private:
  using Scalar = typename numeric::PartOf<Pack>::Type;
  static constexpr Scalar closer = 1 + Scalar(1) / 256;

  /// Whether the displacement of the groups by rounding is negligible, by the criterion of
  /// `place_group`, or they are regular despite their displacement.
  [[nodiscard]] Truth is_regular_among_displaced(
      const support::HeldJoints<Group, Pack, Order, Parameters>& held,
      const DisplacedInputs<Model, Pack>& rounding) const {
    constexpr Scalar own = support::own_length<Group, Pack>;
    constexpr Scalar little = 16 * std::numeric_limits<Scalar>::epsilon() / closer;
    constexpr Scalar longest = 16 * own;
    Truth is_little =
        (held.displaced.moved <= Pack(little * own)) & (held.displaced.turned <= Pack(little));
    if constexpr (longest < Scalar(support::most_length_of_numbers)) {
      is_little = is_little & (longest_lengths(held.u) <= Pack(longest));
    }
    if (static_cast<bool>(is_little)) {
      return is_little;
    }
    return is_little | are_surely_regular<Model>(typename Model::template Dimensions<Pack>(),
                                                 held.u, group.q, rounding.unsure(held.u));
  }
};

}  // namespace assur::detail::batch
