// Turns a group's dimensions and inputs into all its configurations, in closed form and counted
// with a certificate.
#pragma once

#include <algorithm>
#include <assur/assemblies.hpp>
#include <assur/detail/assembly_order.hpp>
#include <assur/detail/general_search.hpp>
#include <assur/detail/index.hpp>
#include <assur/detail/special_group.hpp>
#include <assur/support/scale.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <type_traits>

namespace assur {

/// Every assembly configuration: all q with F(d, u, q) = 0, the closures F in the comment of the
/// model. Lengths share any unit, directions among dimensions and inputs must be unit vectors;
/// configurations are in the frame and the unit of the inputs. `displaced` is a length: how far
/// rounding may have moved any input, for example because another group was placed before.
///
/// The final polynomial's real roots are isolated with a bound of all rounding, of the inputs too;
/// where that does not settle the list, the group is searched as one in special position (see
/// detail/special_search.hpp). What meets to within rounding is listed once and marked
/// near_singular. Status: ok, also where the links cannot reach, with no configuration; degenerate;
/// not_finite.
template <typename Model>
[[nodiscard]] Assemblies<Model> assemblies(
    const typename Model::template Dimensions<double>& dimensions,
    const typename Model::template Inputs<double>& inputs, double displaced = 0) {
  static_assert(Model::rigid, "a degenerate model has no closed form");
  using Dimensions = typename Model::template Dimensions<double>;
  using Inputs = typename Model::template Inputs<double>;
  Assemblies<Model> result;
  if (!is_finite(dimensions) || !is_finite(inputs)) {
    result.status = AssemblyStatus::not_finite;
    return result;
  }
  const double scale = support::unit_scale<Model>(dimensions, inputs, displaced);
  const auto d = support::scaled_to<Dimensions>(dimensions, scale);
  const auto u = support::scaled_to<Inputs>(inputs, scale);
  const double held = std::min(displaced * scale, support::most_displaced);
  if (!detail::GeneralSearch<Model>(d, u, held, result).run()) {
    detail::search_in_special_position<Model>(d, u, held, result);
  }
  if (result.count > 1) {
    detail::put_in_order<Model>(d, u, result);
  }
  for (int index = 0; index < result.count; ++index) {
    auto& q = detail::entry(result.configurations, index);
    q = support::scaled_to<std::decay_t<decltype(q)>>(q, 1 / scale);
  }
  return result;
}

/// By how much the loop closures fail at least, in the unit of the lengths, where the links cannot
/// reach: the largest of |F(d, u, q)| at the best q that a search from some places finds. Set where
/// the status is ok; not_finite.
template <typename Model>
[[nodiscard]] Status closure_gap(const typename Model::template Dimensions<double>& dimensions,
                                 const typename Model::template Inputs<double>& inputs,
                                 double& gap) {
  static_assert(Model::rigid, "a degenerate model has no closed form");
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
