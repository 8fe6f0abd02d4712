// Turns a group's dimensions and inputs into all its configurations, in closed form and counted
// with a certificate.
#pragma once

#include <algorithm>
#include <assur/assemblies.hpp>
#include <assur/detail/assembly_order.hpp>
#include <assur/detail/closed_search.hpp>
#include <assur/detail/general_search.hpp>
#include <assur/detail/index.hpp>
#include <assur/detail/special_group.hpp>
#include <assur/numeric/arithmetic.hpp>
#include <assur/support/displaced_frame.hpp>
#include <assur/support/scale.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <type_traits>

namespace assur {

namespace detail {

/// Every configuration, where the formula alone does not vouch for the list.
template <typename Model>
[[gnu::noinline, gnu::cold]] void search(
    const typename Model::template Dimensions<double>& dimensions,
    const typename Model::template Inputs<double>& inputs, const support::Displacement& given,
    Assemblies<Model>& result) {
  using Dimensions = typename Model::template Dimensions<double>;
  using Inputs = typename Model::template Inputs<double>;
  if (!numeric::sums_are_exact()) {
    result.status = AssemblyStatus::unsound_arithmetic;
    return;
  }
  const support::Displacement displaced = given.bounded();
  if constexpr (has_closed_form<Model>) {
    if (ClosedSearch<Model>::list_polished(dimensions, inputs, displaced, result)) {
      return;
    }
  }
  if (!is_finite(dimensions) || !is_finite(inputs)) {
    result.status = AssemblyStatus::not_finite;
    return;
  }
  const double size = support::size_among<Model>(dimensions, inputs, displaced);
  if (size < support::least_size && !numeric::keeps_subnormals()) {
    result.status = AssemblyStatus::unsound_arithmetic;
    return;
  }
  const double scale = support::scale_of(size);
  const auto d = support::scaled_to<Dimensions>(dimensions, scale);
  const auto u = support::scaled_to<Inputs>(inputs, scale);
  // Lengths are near one: a turn moves their ends by as much.
  const double off = (std::max)(displaced.moved * scale, displaced.turned);
  const double held = support::counted_displacement(off, (std::max)(1.0, displaced.reach * scale));
  bool found = false;
  if constexpr (!has_closed_form<Model>) {
    found = GeneralSearch<Model>(d, u, held, off, result).run();
  }
  if (!found) {
    const double unsure = support::unsure_jacobian<Model>(dimensions, inputs, displaced);
    search_in_special_position<Model>(d, u, held, unsure, result);
  }
  list_in<Model>(d, u, 1 / scale, result);
}

}  // namespace detail

/// Every assembly configuration: all q with F(d, u, q) = 0, the closures F in the comment of the
/// model. Lengths share any unit, directions among dimensions and inputs must be unit vectors;
/// configurations are in the frame and the unit of the inputs. `displaced` tells how far rounding
/// may have moved and turned any input, for example because another group was placed before, and
/// the longest length from which the inputs were computed, if it is longer than the group.
///
/// A final polynomial of first or second degree is solved by formula where its discriminant is
/// larger than all rounding, of the inputs too; of one of higher degree the real roots are isolated
/// with such a bound. Where that does not settle the list, the group is searched as one in special
/// position (see detail/special_search.hpp). What meets to within rounding is listed once and
/// marked near_singular. Coordinates count as known to a rounding of
/// their own, and verdicts on the derivatives with them: far from the origin, as on what rounding
/// has displaced, fewer configurations are ok. Status: ok, also where the links cannot reach, with
/// no configuration; degenerate; not_finite; unsound_arithmetic.
template <typename Model>
[[nodiscard]] Assemblies<Model> assemblies(
    const typename Model::template Dimensions<double>& dimensions,
    const typename Model::template Inputs<double>& inputs,
    const support::Displacement& displaced = {}) {
  static_assert(Model::rigid, "a degenerate model has no closed form");
  Assemblies<Model> result;
  if constexpr (!numeric::rounds_as_written) {
    result.status = AssemblyStatus::unsound_arithmetic;
  } else {
    bool found = false;
    if constexpr (detail::has_closed_form<Model>) {
      found = detail::ClosedSearch<Model>::list(dimensions, inputs, displaced, result);
    }
    if (!found) {
      detail::search<Model>(dimensions, inputs, displaced, result);
    }
  }
  return result;
}

/// By how much the loop closures fail at least, in the unit of the lengths, where the links cannot
/// reach: the largest of |F(d, u, q)| at the best q that a search from some places finds. Set where
/// the status is ok; not_finite; unsound_arithmetic.
template <typename Model>
[[nodiscard]] Status closure_gap(const typename Model::template Dimensions<double>& dimensions,
                                 const typename Model::template Inputs<double>& inputs,
                                 double& gap) {
  static_assert(Model::rigid, "a degenerate model has no closed form");
  if (!numeric::rounds_as_written || !numeric::sums_are_exact()) {
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
