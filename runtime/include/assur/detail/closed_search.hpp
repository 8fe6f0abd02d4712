// Configurations in closed form of a group whose final polynomial has one or two roots; doubtful
// groups are left to the general search.
#pragma once

#include <algorithm>
#include <assur/assemblies.hpp>
#include <assur/detail/assembly_order.hpp>
#include <assur/detail/closed_form.hpp>
#include <assur/detail/completion.hpp>
#include <assur/detail/polish.hpp>
#include <assur/numeric/bounded.hpp>
#include <assur/numeric/pair.hpp>
#include <assur/numeric/precision.hpp>
#include <assur/support/displaced_frame.hpp>
#include <assur/support/scale.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <cstddef>
#include <limits>

namespace assur::detail {

/// The search by formula. Its list is certain if the discriminant has a certain sign for any
/// rounding of dimensions and inputs, and all listed configurations close.
template <typename Model, typename Number = double>
class ClosedSearch {
  using Dimensions = typename Model::template Dimensions<Number>;
  using Inputs = typename Model::template Inputs<Number>;
  using Configuration = typename Model::template Configuration<Number>;
  static constexpr auto root_count = static_cast<std::size_t>(Model::max_configurations);
  using Scalar = AllRoots<Model, Number>;
  using Displacement = support::DisplacementOf<Number>;

 public:
  /// Searches a group without scaling it, which suffices for most. False if the list is not
  /// certain; it is undefined then.
  [[nodiscard, gnu::flatten]] static bool list(const Dimensions& dimensions, const Inputs& inputs,
                                               const Displacement& displaced,
                                               Assemblies<Model, Number>& result) {
    const auto of_dimensions = square_of_lengths<Number>(dimensions);
    const Number square = of_dimensions + square_of_lengths<Number>(inputs);
    if (!static_cast<bool>(Form::is_in_range(square))) {
      return false;
    }
    FinalPolynomial<Model, Number> T;
    Model::position_polynomial(dimensions, inputs, T);
    const Discriminants<Number> found = discriminants_of(T);
    const Number in_units = Form::is_scaled ? square : 1;
    const Number error = Form::discriminant.error(in_units, displaced);
    if (!(found.discriminant * Form::firmness > error)) {
      return found.discriminant * Form::discriminant.firmness < -error && is_finite(dimensions) &&
             is_finite(inputs);
    }
    if constexpr (Form::has_leading_coefficient) {
      constexpr auto leading = certainty<Number>(Model::leading_error, Model::leading_degree);
      if (!(std::abs(found.leading) * leading.firmness > leading.error(in_units, displaced))) {
        return false;
      }
    }
    const auto d = support::converted_to<typename Model::template Dimensions<Scalar>>(dimensions);
    const auto u = support::converted_to<typename Model::template Inputs<Scalar>>(inputs);
    typename Model::template Configuration<Scalar> q;
    first_of<Model>(q) = roots_of(T, found);
    const auto unsure = [&] {
      // Near the origin this is no larger than the rounding of the lengths, which every verdict
      // includes.
      const bool counts =
          displaced.moved > 0 || displaced.turned > 0 || square > 256 * of_dimensions;
      return counts ? support::unsure_jacobian<Model, Number>(dimensions, inputs, displaced) : 0;
    };
    if (!completes(d, u, q, square, unsure)) {
      return false;
    }
    std::size_t first = 0;
    if constexpr (root_count == 2 && !comes_in_any_order<Model>) {
      first = comes_before<Model, Number>(d, u, q, in_units) ? 0 : 1;
    }
    for (std::size_t index = 0; index < root_count; ++index) {
      result.configurations[index ^ first] = lane_of<Configuration>(q, index);
      result.regularity[index] = Status::ok;
    }
    result.count = static_cast<int>(root_count);
    return true;
  }

  /// A more careful search: the error bounds are those for these dimensions and inputs, much
  /// tighter if many lengths are multiplied, and configurations are polished. False if the list is
  /// not certain.
  [[nodiscard, gnu::noinline, gnu::cold]] static bool list_polished(
      const Dimensions& dimensions, const Inputs& inputs, const Displacement& displaced,
      Assemblies<Model, Number>& result) {
    const Number longest = (std::max)(longest_length(inputs), longest_length(dimensions));
    // A group that is scaled may have any unit whose scale is representable.
    constexpr auto most = numeric::power_of_two<Number>(most_power_of_scale);
    const bool is_in_range = Form::is_scaled ? longest * most > 1 && longest < most
                                             : longest <= most_length<Model, Number>;
    if (!is_in_range || !is_finite(dimensions) || !is_finite(inputs)) {
      return false;
    }
    const Number scale = Form::is_scaled ? support::inverse_power_of_two(longest) / 2 : 1;
    const auto d = support::scaled_to<Dimensions>(dimensions, scale);
    const auto u = support::scaled_to<Inputs>(inputs, scale);
    FinalPolynomial<Model, Number> T;
    Model::position_polynomial(d, u, T);
    const Discriminants<Number> found = discriminants_of(T);
    const Displacement scaled = displaced.scaled(scale);
    if (!is_certain(d, u, scaled)) {
      return false;
    }
    if (found.discriminant < 0) {
      return true;
    }
    const Number unsure = support::unsure_jacobian<Model, Number>(d, u, scaled);
    const auto roots = roots_of(T, found);
    for (std::size_t index = 0; index < root_count; ++index) {
      Configuration& q = result.configurations[index];
      first_of<Model>(q) = numeric::lane(roots, index);
      if (!complete<Model, Number>(d, u, q)) {
        return false;
      }
      // If a discriminant certifies the configurations, it determines all unknowns.
      result.regularity[index] =
          polish<Model, Number>(d, u, q, unsure, Form::determines ? 0 : loose_margin<Number>);
      if (!is_solvable(result.regularity[index])) {
        return false;
      }
    }
    result.count = static_cast<int>(root_count);
    if (has_twins<Model, Number>(result)) {
      result.count = 0;
      return false;
    }
    list_in<Model, Number>(d, u, 1 / scale, result);
    return true;
  }

 private:
  using Form = ClosedForm<Model, Number>;
  /// Lengths between two to this power and its inverse can be scaled.
  static constexpr int most_power_of_scale =
      std::numeric_limits<Number>::max_exponent * 500 / std::numeric_limits<double>::max_exponent;

  /// Completes the configurations at the roots. Returns whether they close to a few roundings and
  /// are regular for a Jacobian with the error `unsure`. If a discriminant certifies them, they are
  /// regular.
  template <typename ScalarDimensions, typename ScalarInputs, typename Roots, typename Unsure>
  [[nodiscard]] static bool completes(const ScalarDimensions& d, const ScalarInputs& u, Roots& q,
                                      Number square, const Unsure& unsure) {
    // `square / 2` stands for the square of the longest length; its root is at most 1.8 times as
    // long.
    const auto holds = [&] { return closes<Model, Scalar>(d, u, q, square / 2); };
    if constexpr (Form::vouches) {
      const Scalar miss = complete_root<Model, Scalar>(d, u, q);
      return !completes_angles<Model> ||
             static_cast<bool>(miss <= Scalar(settled_direction<Number>)) ||
             static_cast<bool>(holds());
    } else {
      // `holds` reads what this completes, and the operands of `&` may be evaluated in any order.
      const auto is_complete = complete_simple<Model, Scalar>(d, u, q);
      return static_cast<bool>(is_complete & holds()) &&
             is_regular<Model, Scalar>(d, u, q, unsure());
    }
  }

  [[nodiscard]] static bool is_certain(const Dimensions& d, const Inputs& u,
                                       const Displacement& displaced) {
    using Certified = numeric::Bounded<Number>;
    FinalPolynomial<Model, Certified> T;
    Model::position_polynomial(
        support::rounded<typename Model::template Dimensions<Certified>>(
            d, support::rounding_of_one<Number>, support::rounding_of_one<Number>),
        support::rounded<typename Model::template Inputs<Certified>>(
            u, support::rounding_of_inputs(u, displaced.moved),
            support::rounding_of_inputs(u, (std::max)(displaced.moved, displaced.turned))),
        T);
    constexpr Number lost = numeric::lost_in_underflow<Number>;
    widen(T, Certified(0, support::rounding_of_numbers<Model, Number>() + lost));
    const Discriminants<Certified> found = discriminants_of(T);
    return found.discriminant.sign_is_certain() && found.leading.sign_is_certain() &&
           found.discriminant.size() > lost && found.leading.size() > lost;
  }
};

}  // namespace assur::detail
