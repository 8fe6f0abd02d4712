// Conversion of a group from float to double, and of its configurations back to float.
#pragma once

#include <assur/assemblies.hpp>
#include <assur/detail/index.hpp>
#include <assur/detail/numbers.hpp>
#include <assur/directions.hpp>
#include <assur/kinematics.hpp>
#include <assur/model.hpp>
#include <assur/support/displaced_frame.hpp>
#include <assur/variables.hpp>
#include <type_traits>

namespace assur::detail {

/// The variables in double. Lengths are converted exactly; directions are unit vectors to the
/// digits of float and become unit vectors to those of double, by two steps that square the error
/// each.
template <typename Wide, typename Variables>
[[nodiscard]] Wide widened(const Variables& variables) {
  Wide result;
  for_each_pair(result, variables, [](auto& wide, const auto& member) {
    if constexpr (is_direction<std::decay_t<decltype(member)>>) {
      const Direction<double> exact{static_cast<double>(member.cos),
                                    static_cast<double>(member.sin)};
      wide = normalised(normalised(exact));
    } else {
      wide = static_cast<double>(member);
    }
  });
  return result;
}

/// The variables, rounded to a narrower scalar.
template <typename Narrow, typename Variables>
[[nodiscard]] Narrow narrowed(const Variables& variables) {
  using Scalar = typename ScalarOf<Narrow>::Type;
  Narrow result;
  for_each_pair(result, variables, [](auto& narrow, const auto& member) {
    if constexpr (is_direction<std::decay_t<decltype(member)>>) {
      narrow = {static_cast<Scalar>(member.cos), static_cast<Scalar>(member.sin)};
    } else {
      narrow = static_cast<Scalar>(member);
    }
  });
  return result;
}

/// Rounds the configurations found in double. The verdicts are those of the narrower scalar, in
/// which all derivatives are computed; the Jacobian has the error `unsure`.
template <typename Model, typename Scalar>
void round_answer(const typename Model::template Dimensions<Scalar>& d,
                  const typename Model::template Inputs<Scalar>& u, Scalar unsure,
                  const Assemblies<Model>& found, Assemblies<Model, Scalar>& result) {
  result.status = found.status;
  result.count = found.count;
  result.mobility = found.mobility;
  for (int index = 0; index < found.count; ++index) {
    auto& q = entry(result.configurations, index);
    q = narrowed<std::decay_t<decltype(q)>>(entry(found.configurations, index));
    const bool is_regular = assur::regularity<Model, Scalar>(d, u, q, unsure).status == Status::ok;
    entry(result.regularity, index) =
        is_regular ? entry(found.regularity, index) : Status::near_singular;
  }
}

}  // namespace assur::detail
