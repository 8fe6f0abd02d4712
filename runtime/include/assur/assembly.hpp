// All assembly configurations of a group, in closed form, with a certificate of their number.
#pragma once

#include <algorithm>
#include <assur/assemblies.hpp>
#include <assur/detail/assembly_order.hpp>
#include <assur/detail/closed_search.hpp>
#include <assur/detail/general_search.hpp>
#include <assur/detail/index.hpp>
#include <assur/detail/special_group.hpp>
#include <assur/detail/wider.hpp>
#include <assur/numeric/arithmetic.hpp>
#include <assur/support/displaced_frame.hpp>
#include <assur/support/scale.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <type_traits>

namespace assur {

namespace detail {

/// Whether the configurations of a model are selected from its complex ones, as for groups with
/// more than four links (support/loop_group.hpp).
template <typename Model, typename = void>
inline constexpr bool is_searched_in_complex_numbers = false;
template <typename Model>
inline constexpr bool
    is_searched_in_complex_numbers<Model, std::void_t<decltype(Model::eliminations)>> = true;
template <typename Model, typename Scalar>
void ask_double(const typename Model::template Dimensions<Scalar>& d,
                const typename Model::template Inputs<Scalar>& u,
                const support::DisplacementOf<Scalar>& displaced,
                Assemblies<Model, Scalar>& result);

/// All configurations where the formula alone does not certify the list. If float is not
/// sufficient, a pair of floats is tried; if that is not sufficient either, the status is
/// unresolved.
template <typename Model, typename Scalar>
[[gnu::noinline, gnu::cold]] void search(
    const typename Model::template Dimensions<Scalar>& dimensions,
    const typename Model::template Inputs<Scalar>& inputs,
    const support::DisplacementOf<Scalar>& given, Assemblies<Model, Scalar>& result) {
  using Dimensions = typename Model::template Dimensions<Scalar>;
  using Inputs = typename Model::template Inputs<Scalar>;
  if (!numeric::sums_are_exact<Scalar>()) {
    result.status = AssemblyStatus::unsound_arithmetic;
    return;
  }
  const support::DisplacementOf<Scalar> displaced = given.bounded();
  if constexpr (has_closed_form<Model>) {
    if (ClosedSearch<Model, Scalar>::list_polished(dimensions, inputs, displaced, result)) {
      return;
    }
  }
  if (!is_finite(dimensions) || !is_finite(inputs)) {
    result.status = AssemblyStatus::not_finite;
    return;
  }
  const Scalar size = support::size_among<Model, Scalar>(dimensions, inputs, displaced);
  if (size < support::least_size<Scalar> && !numeric::keeps_subnormals<Scalar>()) {
    result.status = AssemblyStatus::unsound_arithmetic;
    return;
  }
  const Scalar scale = support::scale_of(size);
  const auto d = support::scaled_to<Dimensions>(dimensions, scale);
  const auto u = support::scaled_to<Inputs>(inputs, scale);
  // Lengths are near one, so a rotation moves their ends by about its angle.
  const Scalar off = (std::max)(displaced.moved * scale, displaced.turned);
  const Scalar held =
      support::counted_displacement(off, (std::max)(Scalar(1), displaced.reach * scale));
  bool found = false;
  if constexpr (!has_closed_form<Model>) {
    found = GeneralSearch<Model, Scalar, Scalar>(d, u, held, off, result).run();
    if constexpr (!std::is_same_v<Scalar, double>) {
      if (!found) {
        result = {};
        found = GeneralSearch<Model, Scalar, numeric::DoubleWord<Scalar>>(d, u, held, off, result)
                    .run();
      }
    }
  }
  if (!found) {
    if constexpr (std::is_same_v<Scalar, double>) {
      const double unsure = support::unsure_jacobian<Model>(dimensions, inputs, displaced);
      search_in_special_position<Model>(d, u, held, unsure, result);
    } else {
      result = {};
      result.status = AssemblyStatus::unresolved;
      return;
    }
  }
  list_in<Model, Scalar>(d, u, 1 / scale, result);
}

}  // namespace detail

/// All assembly configurations: all q with F(d, u, q) = 0; the comment of the model states the
/// closures F. All lengths have one unit, which is free; directions among dimensions and inputs
/// must be unit vectors. Configurations are in the frame and the unit of the inputs. `displaced`
/// bounds the translation and rotation of the inputs by earlier rounding, for example in the groups
/// solved before, and holds the longest length from which the inputs were computed, if it exceeds
/// the group.
///
/// A final polynomial of first or second degree is solved by formula if its discriminant exceeds
/// all rounding errors, those of the inputs included. The real roots of one of higher degree are
/// isolated with such a bound. If this does not settle the list, the group is searched as one in
/// special position (see detail/special_search.hpp). Configurations that coincide to within
/// rounding are listed once and marked near_singular. The list and the verdicts on the derivatives
/// assume that every coordinate is known to its own rounding only: far from the origin, or if
/// rounding has displaced the inputs, fewer configurations are ok. Status: ok, with no
/// configuration if the links cannot be assembled; degenerate; not_finite; unsound_arithmetic.
///
/// In float, `assemblies<Model, float>`, all bounds are in roundings of float, and there is no
/// search in special position. If that search is needed, `unresolved` selects one of two: the group
/// is solved in double and its configurations are rounded, or the status is `unresolved`.
template <typename Model, typename Scalar = double, Unresolved unresolved = Unresolved::ask_double>
[[nodiscard]] Assemblies<Model, Scalar> assemblies(
    const typename Model::template Dimensions<Scalar>& dimensions,
    const typename Model::template Inputs<Scalar>& inputs,
    const support::DisplacementOf<Scalar>& displaced = {}) {
  static_assert(Model::rigid, "a degenerate model has no closed form");
  Assemblies<Model, Scalar> result;
  if constexpr (!numeric::rounds_as_written<Scalar>) {
    result.status = AssemblyStatus::unsound_arithmetic;
  } else {
    if constexpr (!detail::is_searched_in_complex_numbers<Model>) {
      bool found = false;
      if constexpr (detail::has_closed_form<Model>) {
        found = detail::ClosedSearch<Model, Scalar>::list(dimensions, inputs, displaced, result);
      }
      if (!found) {
        detail::search<Model, Scalar>(dimensions, inputs, displaced, result);
      }
    } else if constexpr (std::is_same_v<Scalar, double>) {
      Model::template search<Model>(dimensions, inputs, displaced, result);
    } else {
      result.status = AssemblyStatus::unresolved;
    }
    if constexpr (!std::is_same_v<Scalar, double> && unresolved == Unresolved::ask_double) {
      if (result.status == AssemblyStatus::unresolved) {
        detail::ask_double<Model, Scalar>(dimensions, inputs, displaced, result);
      }
    }
  }
  return result;
}

namespace detail {

/// Solves the same group in double.
template <typename Model, typename Scalar>
[[gnu::noinline, gnu::cold]] void ask_double(const typename Model::template Dimensions<Scalar>& d,
                                             const typename Model::template Inputs<Scalar>& u,
                                             const support::DisplacementOf<Scalar>& displaced,
                                             Assemblies<Model, Scalar>& result) {
  const Assemblies<Model> found = assur::assemblies<Model>(
      widened<typename Model::template Dimensions<double>>(d),
      widened<typename Model::template Inputs<double>>(u), displaced.in_double());
  round_answer<Model, Scalar>(d, u, support::unsure_jacobian<Model, Scalar>(d, u, displaced), found,
                              result);
}

}  // namespace detail

/// The closure gap of a group that cannot be assembled, in the unit of the lengths: the least local
/// minimum of |F(d, u, q)|, over all closures together, found by a search from several starts. It
/// is set if the status is ok; other statuses are not_finite and unsound_arithmetic.
template <typename Model>
[[nodiscard]] Status closure_gap(const typename Model::template Dimensions<double>& dimensions,
                                 const typename Model::template Inputs<double>& inputs,
                                 double& gap) {
  static_assert(Model::rigid, "a degenerate model has no closed form");
  if (!numeric::sums_are_exact<double>()) {
    return Status::unsound_arithmetic;
  }
  if (!is_finite(dimensions) || !is_finite(inputs)) {
    return Status::not_finite;
  }
  const double scale = support::unit_scale<Model>(dimensions, inputs);
  const auto d = support::scaled_to<typename Model::template Dimensions<double>>(dimensions, scale);
  const auto u = support::scaled_to<typename Model::template Inputs<double>>(inputs, scale);
  gap = detail::SpecialGroupOf<Model>(d, u, 0).least_miss() / scale;
  return std::isfinite(gap) ? Status::ok : Status::not_finite;
}

}  // namespace assur
