// Verdicts on several groups and configurations at once: finiteness, size and certain regularity.
#pragma once

#include <array>
#include <assur/detail/batch/pack_columns.hpp>
#include <assur/detail/pivots.hpp>
#include <assur/support/scale.hpp>
#include <assur/variables.hpp>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace assur::detail::batch {

/// Whether all directions are finite: zero times a number that is not finite is NaN.
template <template <typename> class Variables, typename Pack>
[[nodiscard]] auto are_finite_directions(const Variables<Pack>& variables) {
  Pack zero(0);
  for_each_member(variables, [&zero](const auto& member, std::size_t) {
    if constexpr (is_direction<std::decay_t<decltype(member)>>) {
      zero = zero + member.cos * Pack(0) + member.sin * Pack(0);
    }
  });
  return zero == Pack(0);
}
/// The lanes in which all numbers are finite, by four independent sums.
template <typename Pack>
class FiniteNumbers {
  std::array<Pack, 4> zeros_ = {Pack(0), Pack(0), Pack(0), Pack(0)};

 public:
  void look_at(const Pack& number, std::size_t place) { zeros_[place % 4] += number * Pack(0); }
  [[nodiscard]] auto all() const {
    return (zeros_[0] + zeros_[1]) + (zeros_[2] + zeros_[3]) == Pack(0);
  }
};
/// The longest length of each group, as in `longest_length`.
template <template <typename> class Variables, typename Pack>
[[nodiscard]] Pack longest_lengths(const Variables<Pack>& variables) {
  Pack longest(0);
  for_each_member(variables, [&longest](const auto& member, std::size_t) {
    if constexpr (!is_direction<std::decay_t<decltype(member)>>) {
      longest = max EIGEN_NOT_A_MACRO(longest, abs(member));
    }
  });
  return longest;
}

/// The longest length of each group, independent of its position, as in `size_of`.
template <typename Model, typename Pack>
[[nodiscard]] Pack sizes_of(const typename Model::template Dimensions<Pack>& d,
                            const typename Model::template Inputs<Pack>& u) {
  typename Model::template Configuration<Pack> q;
  Vector<Pack, Model::equation_count> f;
  Model::residual(typename Model::template Dimensions<Pack>{}, u, q, f);
  Pack longest = longest_lengths(d);
  for (int index = 0; index < Model::equation_count; ++index) {
    longest = max EIGEN_NOT_A_MACRO(longest, abs(f(index)));
  }
  return longest;
}

/// Bound on the error of the loop Jacobian of each group, as in `unsure_jacobian`.
template <typename Model, typename Pack>
[[nodiscard]] Pack unsure_jacobians(const typename Model::template Dimensions<Pack>& d,
                                    const typename Model::template Inputs<Pack>& u) {
  const Pack epsilon(std::numeric_limits<typename numeric::PartOf<Pack>::Type>::epsilon());
  if constexpr (has_angles<Model>) {
    return epsilon * longest_lengths(u) / sizes_of<Model, Pack>(d, u);
  } else {
    return epsilon;
  }
}

/// Whether a configuration is regular, even with an error of a few roundings. If not, the functions
/// for one group decide.
template <typename Model, typename Pack>
[[nodiscard]] auto are_surely_regular(const typename Model::template Dimensions<Pack>& d,
                                      const typename Model::template Inputs<Pack>& u,
                                      const typename Model::template Configuration<Pack>& q,
                                      const Pack& unsure) {
  using Scalar = typename numeric::PartOf<Pack>::Type;
  constexpr Scalar closer = 1 + Scalar(1) / 256;
  return are_regular<Model>(pivots_at<Model, Pack>(d, u, q),
                            Pack(closer) * (Pack(derivative_rounding<Scalar>()) + unsure));
}

}  // namespace assur::detail::batch
