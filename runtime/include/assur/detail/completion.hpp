// Turns a configuration whose first unknown is known into a whole one.
#pragma once

#include <assur/detail/index.hpp>
#include <assur/numeric/second_unknown.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <tuple>
#include <type_traits>

namespace assur::detail {

/// The other unknowns at a simple root of the final polynomial, where one second value fits. False
/// where none does, or where what should be a direction is none: between ends that coincide a bar
/// has no direction, whatever its length. What is not finite is left to those who close it.
template <typename Model>
[[nodiscard]] bool complete(const typename Model::template Dimensions<double>& d,
                            const typename Model::template Inputs<double>& u,
                            typename Model::template Configuration<double>& q) {
  if constexpr (Model::second_unknown >= 0) {
    auto& second = std::get<size(Model::second_unknown)>(q.members());
    Matrix<double, 2, 3> e;
    Model::second_equations(d, u, q, e);
    const auto candidates = numeric::second_candidates<std::decay_t<decltype(second)>>(e);
    if (candidates.count == 0) {
      return false;
    }
    second = candidates.list[0].value;
  }
  Model::complete(d, u, q);
  bool fits = true;
  for_each_member(q, [&fits](auto& member, std::size_t) {
    if constexpr (!std::is_same_v<std::decay_t<decltype(member)>, double>) {
      const double square = member.cos * member.cos + member.sin * member.sin;
      fits = fits && std::abs(square - 1) < 0.1;
      member = normalised(member);
    }
  });
  return fits;
}

}  // namespace assur::detail
