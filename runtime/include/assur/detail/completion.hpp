// The remaining unknowns of a configuration, from the first one.
#pragma once

#include <assur/detail/index.hpp>
#include <assur/numeric/second_unknown.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>

namespace assur::detail {

/// The first unknown of a model's final polynomial.
template <typename Model, typename Configuration>
[[nodiscard]] auto& first_of(Configuration& q) {
  return std::get<size(Model::first_unknown)>(q.members());
}

/// Normalises a direction to first order, like `normalised`. Returns the error of its squared
/// length before.
template <typename Scalar>
Scalar put_on_circle(Direction<Scalar>& direction) {
  const Scalar off = direction.cos * direction.cos + direction.sin * direction.sin - Scalar(1);
  const Scalar scale = Scalar(1) - Scalar(0.5) * off;
  direction = {direction.cos * scale, direction.sin * scale};
  return off;
}

/// Computes the remaining unknowns from those of the reduced equations. False if a computed
/// direction is not a unit vector: a bar whose ends coincide has no direction, whatever its length.
/// Displacements that are not finite are found when the closures are checked.
template <typename Model, typename Scalar>
[[nodiscard]] auto complete_rest(const typename Model::template Dimensions<Scalar>& d,
                                 const typename Model::template Inputs<Scalar>& u,
                                 typename Model::template Configuration<Scalar>& q) {
  Model::complete(d, u, q);
  Scalar miss(0);
  for_each_member(q, [&miss](auto& member, std::size_t) {
    if constexpr (!std::is_same_v<std::decay_t<decltype(member)>, Scalar>) {
      const Scalar off = put_on_circle(member);
      miss = miss + off * off;
    }
  });
  return miss < Scalar(0.01);
}

/// Whether an unknown that is computed from the first is an angle.
template <typename Model>
inline constexpr bool completes_angles = [] {
  bool any = false;
  for (int unknown = 0; unknown < Model::unknown_count; ++unknown) {
    any = any || (unknown != Model::first_unknown && is_angle<Model>(unknown));
  }
  return any;
}();

/// The largest error of the squared length of a computed direction for its link to close: the
/// residual is the link's length times half of that error.
template <typename Scalar>
inline constexpr Scalar settled_direction = 8 * std::numeric_limits<Scalar>::epsilon();

/// Computes the remaining unknowns at a root that is a unit vector to a few roundings. Returns the
/// largest error of the squared lengths of the other directions.
template <typename Model, typename Scalar>
[[nodiscard]] Scalar complete_root(const typename Model::template Dimensions<Scalar>& d,
                                   const typename Model::template Inputs<Scalar>& u,
                                   typename Model::template Configuration<Scalar>& q) {
  using std::abs;
  Model::complete(d, u, q);
  Scalar miss(0);
  for_each_member(q, [&miss](auto& member, std::size_t index) {
    if constexpr (!std::is_same_v<std::decay_t<decltype(member)>, Scalar>) {
      if (index != size(Model::first_unknown)) {
        miss = max EIGEN_NOT_A_MACRO(miss, abs(put_on_circle(member)));
      }
    }
  });
  return miss;
}

/// Computes the other unknowns at a simple root of the final polynomial, with the second value that
/// fits best. False if there is none, or if the result is not a configuration.
template <typename Model, typename Scalar>
[[nodiscard]] bool complete(const typename Model::template Dimensions<Scalar>& d,
                            const typename Model::template Inputs<Scalar>& u,
                            typename Model::template Configuration<Scalar>& q) {
  if constexpr (Model::second_unknown >= 0) {
    auto& second = std::get<size(Model::second_unknown)>(q.members());
    Matrix<Scalar, 2, 3> e;
    Model::second_equations(d, u, q, e);
    const auto candidates = numeric::second_candidates<std::decay_t<decltype(second)>>(e);
    if (candidates.count == 0) {
      return false;
    }
    second = candidates.list[0].value;
  }
  return complete_rest<Model, Scalar>(d, u, q);
}

/// The same if the two reduced equations together determine the second unknown well. The caller
/// must check that the result closes.
template <typename Model, typename Scalar>
[[nodiscard]] auto complete_simple(const typename Model::template Dimensions<Scalar>& d,
                                   const typename Model::template Inputs<Scalar>& u,
                                   typename Model::template Configuration<Scalar>& q) {
  if constexpr (Model::second_unknown >= 0) {
    auto& second = std::get<size(Model::second_unknown)>(q.members());
    Matrix<Scalar, 2, 3> e;
    Model::second_equations(d, u, q, e);
    second = numeric::common_root<std::decay_t<decltype(second)>>(e);
  }
  return complete_rest<Model, Scalar>(d, u, q);
}

}  // namespace assur::detail
