// Configurations in closed form of several groups at once whose final polynomials have one or two
// roots; doubtful groups are reported.
#pragma once

#include <array>
#include <assur/detail/assembly_order.hpp>
#include <assur/detail/batch/pack_columns.hpp>
#include <assur/detail/batch/pack_order.hpp>
#include <assur/detail/batch/pack_verdicts.hpp>
#include <assur/detail/closed_form.hpp>
#include <assur/detail/completion.hpp>
#include <assur/detail/polish.hpp>
#include <assur/support/scale.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <cstddef>
#include <utility>

namespace assur::detail::batch {

/// Sets the first unknown of each configuration to a root of the final polynomial, whose
/// discriminant is known, as `roots_of` does. It is set number by number, because compilers copy a
/// list of packs through memory.
template <typename Model, typename Pack, typename Configurations>
void put_roots(const TrigonometricPolynomial<Pack, 1>& T, const Discriminants<Pack>& found,
               Configurations& configurations) {
  const Pack root = sqrt(found.discriminant);
  const Pack scale = Pack(1) / found.leading;
  const Pack cosine = T.cosine[1] * scale;
  const Pack sine = T.sine[1] * scale;
  auto& one = first_of<Model>(configurations[0]);
  auto& other = first_of<Model>(configurations[1]);
  one.cos = -T.cosine[0] * cosine - root * sine;
  one.sin = root * cosine - T.cosine[0] * sine;
  other.cos = -T.cosine[0] * cosine + root * sine;
  other.sin = -root * cosine - T.cosine[0] * sine;
}
template <typename Model, typename Pack, typename Configurations>
void put_roots(const Vector<Pack, 2>& T, const Discriminants<Pack>& /*found*/,
               Configurations& configurations) {
  first_of<Model>(configurations[0]) = -T(0) / T(1);
}
template <typename Model, typename Pack, typename Configurations>
void put_roots(const Vector<Pack, 3>& T, const Discriminants<Pack>& found,
               Configurations& configurations) {
  const Pack root = sqrt(found.discriminant);
  const Pack larger = (T(1) + select(T(1) < Pack(0), -root, root)) * Pack(-0.5);
  first_of<Model>(configurations[0]) = larger / T(2);
  first_of<Model>(configurations[1]) = T(0) / larger;
}

/// Groups whose inputs are known to their own rounding.
template <typename Model, typename Pack>
struct KnownInputs {
  /// The largest error of a discriminant, as in `Certainty::error`.
  template <typename Certainty>
  [[nodiscard]] Pack error(const Certainty& certainty, const Pack& square) const {
    return certainty.power(square);
  }
  /// The error of the Jacobian. It is zero for a group near the origin, where it does not exceed
  /// the rounding of the group's lengths, which every verdict includes.
  [[nodiscard]] Pack unsure(const typename Model::template Dimensions<Pack>& d,
                            const typename Model::template Inputs<Pack>& u, const Pack& square,
                            const Pack& of_dimensions) const {
    return select(square > Pack(256) * of_dimensions, unsure_jacobians<Model>(d, u), Pack(0));
  }
};

/// The search by formula for several groups at once, as `ClosedSearch` for one. `Rounding` gives
/// the errors of the inputs.
template <typename Model, typename Pack, typename Rounding = KnownInputs<Model, Pack>>
struct ClosedPack {
  using Scalar = typename numeric::PartOf<Pack>::Type;
  using Truth = decltype(Pack() < Pack());
  using Dimensions = typename Model::template Dimensions<Pack>;
  using Inputs = typename Model::template Inputs<Pack>;
  using Configuration = typename Model::template Configuration<Pack>;
  static constexpr auto root_count = size(Model::max_configurations);

  /// The lanes in which the formula certifies the list; the other groups are searched one by one.
  Truth settled;
  /// The settled lanes whose list is full; the lists of the other settled lanes are empty.
  Truth assembled;
  /// The sorted configurations; set in the lanes that are settled and assembled, and all of them
  /// are ok.
  std::array<Configuration, root_count> configurations;

  ClosedPack(const Dimensions& d, const Inputs& u, const Rounding& rounding = {}) {
    const Pack of_dimensions = square_of_lengths<Pack>(d);
    const Pack square = of_dimensions + square_of_lengths<Pack>(u);
    FinalPolynomial<Model, Pack> T;
    Model::position_polynomial(d, u, T);
    const Discriminants<Pack> found = discriminants_of(T);
    const Pack in_units = Form::is_scaled ? square : Pack(1);
    const Pack error = rounding.error(Form::discriminant, in_units);
    const Truth known =
        Form::is_in_range(square) & are_finite_directions(d) & are_finite_directions(u);
    assembled = known & (found.discriminant * Pack(Form::firmness) > error);
    const Truth none = known & (found.discriminant * Pack(Form::discriminant.firmness) < -error);
    settled = none | assembled;
    // There is no early return if no lane is assembled: configurations would then pass through
    // memory.
    if constexpr (Form::has_leading_coefficient) {
      constexpr auto leading = certainty<Scalar>(Model::leading_error, Model::leading_degree);
      assembled = assembled &
                  (abs(found.leading) * Pack(leading.firmness) > rounding.error(leading, in_units));
    }
    put_roots<Model>(T, found, configurations);
    const auto unsure = [&] { return rounding.unsure(d, u, square, of_dimensions); };
#pragma GCC unroll 2
    for (std::size_t index = 0; index < root_count; ++index) {
      assembled = assembled & completes(d, u, square, unsure, configurations[index]);
    }
    settled = none | assembled;
    if constexpr (root_count == 2 && !comes_in_any_order<Model>) {
      exchange_where(!comes_first(d, u, in_units), configurations[0], configurations[1]);
    }
  }

 private:
  using Form = ClosedForm<Model, Scalar>;

  template <typename Unsure>
  [[nodiscard]] Truth completes(const Dimensions& d, const Inputs& u, const Pack& square,
                                const Unsure& unsure, Configuration& q) const {
    const auto holds = [&] { return closes<Model, Pack>(d, u, q, square * Pack(0.5)); };
    if constexpr (Form::vouches) {
      const Pack miss = complete_root<Model, Pack>(d, u, q);
      if constexpr (!completes_angles<Model>) {
        return Pack(0) < Pack(1);
      }
      const Truth settles = miss <= Pack(settled_direction<Scalar>);
      return static_cast<bool>(settles | !assembled) ? settles : settles | holds();
    } else {
      const Truth is_complete = complete_simple<Model, Pack>(d, u, q);
      return is_complete & holds() & are_surely_regular<Model>(d, u, q, unsure());
    }
  }

  /// Whether the first of two configurations comes before the second, as in `comes_before`.
  [[nodiscard]] Truth comes_first(const Dimensions& d, const Inputs& u, const Pack& square) const {
    const auto by_all = [&] {
      return come_before_by_keys<Model, Pack>(d, u, configurations[0], configurations[1],
                                              sqrt(square));
    };
    constexpr int place = first_place;
    if constexpr (place < 0) {
      return by_all();
    } else {
      const Pack one = key_at<Model, place, Pack>(d, u, configurations[0]);
      const Pack other = key_at<Model, place, Pack>(d, u, configurations[1]);
      const Truth first = one < other;
      if constexpr (Form::vouches) {
        return first;
      }
      const Truth apart =
          abs(one - other) > Pack(numeric::key_rounding<Scalar>) * (Pack(1) + abs(one));
      return static_cast<bool>(apart | !assembled) ? first : by_all();
    }
  }
  static constexpr int first_place = [] {
    if constexpr (Form::vouches) {
      return Model::first_key;
    } else {
      return Model::link_count > 1 ? 0 : -1;
    }
  }();
};

}  // namespace assur::detail::batch
