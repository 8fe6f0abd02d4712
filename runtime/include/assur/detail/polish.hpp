// Newton polishing of a nearly closed configuration to a few roundings.
#pragma once

#include <algorithm>
#include <assur/assemblies.hpp>
#include <assur/detail/closure_geometry.hpp>
#include <assur/detail/index.hpp>
#include <assur/detail/numbers.hpp>
#include <assur/detail/pivots.hpp>
#include <assur/detail/small_step.hpp>
#include <assur/kinematics.hpp>
#include <assur/numeric/precision.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace assur::detail {

/// Whether the closures hold to within a few rounding errors. `square` is the square of the longest
/// given length.
template <typename Model, typename Scalar, typename Square>
[[nodiscard]] auto closes(const typename Model::template Dimensions<Scalar>& d,
                          const typename Model::template Inputs<Scalar>& u,
                          const typename Model::template Configuration<Scalar>& q,
                          const Square& square) {
  using Part = typename numeric::PartOf<Scalar>::Type;
  constexpr Part rounding = 8 * std::numeric_limits<Part>::epsilon();
  constexpr Part farthest = farthest_configuration<Part> * farthest_configuration<Part>;
  Vector<Scalar, Model::equation_count> f;
  Model::residual(d, u, q, f);
  Scalar miss(0);
  for (int index = 0; index < Model::equation_count; ++index) {
    miss = miss + f(index) * f(index);
  }
  const auto lengths = square_of_lengths<Scalar>(q);
  return (miss <= (Scalar(square) + lengths) * Scalar(rounding * rounding)) &
         (lengths < Scalar(farthest) * Scalar(square));
}

/// Whether a configuration is regular. `unsure` is the error of the inputs, relative to the pivots;
/// the rounding error is added.
template <typename Model, typename Scalar>
[[nodiscard]] bool is_regular(const typename Model::template Dimensions<Scalar>& d,
                              const typename Model::template Inputs<Scalar>& u,
                              const typename Model::template Configuration<Scalar>& q,
                              typename numeric::PartOf<Scalar>::Type unsure) {
  return is_regular<Model>(pivots_at<Model, Scalar>(d, u, q),
                           derivative_rounding<typename numeric::PartOf<Scalar>::Type>() + unsure);
}

/// Even at a root that is certainly simple another unknown may be undetermined, and the link may
/// move freely, as between parallel slides. The pivot of this unknown is of the order of rounding,
/// and the margin of the order of its square.
template <typename Scalar>
inline constexpr Scalar loose_margin =
    Scalar(1e5) * std::numeric_limits<Scalar>::epsilon() * std::numeric_limits<Scalar>::epsilon();

/// Takes Newton's steps as long as they reduce a residual above rounding. The longest length is
/// near one; if a displacement is longer, its rounding ends the iteration. Returns `no_convergence`
/// if the closures do not hold then, or if the configuration is not finite; `singular` if its
/// margin is below `least_margin`; otherwise ok or near_singular, for a Jacobian with the error
/// `unsure`.
template <typename Model, typename Scalar>
[[nodiscard, gnu::noinline]] Status polish(const typename Model::template Dimensions<Scalar>& d,
                                           const typename Model::template Inputs<Scalar>& u,
                                           typename Model::template Configuration<Scalar>& q,
                                           Scalar unsure, Scalar least_margin) {
  if (!is_finite(q)) {
    return Status::no_convergence;
  }
  constexpr int steps = 3;
  Vector<Scalar, Model::equation_count> f;
  Model::residual(d, u, q, f);
  Scalar miss = f.cwiseAbs().maxCoeff();
  const InverseJacobian<Model, Scalar> jacobian(d, u, q, unsure);
  constexpr Scalar rounding = 4 * std::numeric_limits<Scalar>::epsilon();
  for (int step = 0; step < steps && miss > rounding && jacobian.solvable(); ++step) {
    auto next = q;
    nudge<Model, Scalar>(next, jacobian.solve(Vector<Scalar, Model::equation_count>(-f)));
    Model::residual(d, u, next, f);
    const Scalar next_miss = f.cwiseAbs().maxCoeff();
    if (!(next_miss < miss)) {
      break;
    }
    q = next;
    miss = next_miss;
  }
  const Scalar longest = longest_length(q);
  if (!(longest < farthest_configuration<Scalar>) ||
      (miss > polished_rounding(Scalar(1)) &&
       !(miss <= polished_rounding((std::max)(longest, longest_length(u)))))) {
    return Status::no_convergence;
  }
  if (!(jacobian.margin() >= least_margin)) {
    return Status::singular;
  }
  return jacobian.status() == Status::ok ? Status::ok : Status::near_singular;
}

/// Whether polishing leads from two roots to one configuration, so that one of them was completed
/// wrongly.
template <typename Model, typename Scalar>
[[nodiscard]] bool has_twins(const Assemblies<Model, Scalar>& found) {
  for (int index = 1; index < found.count; ++index) {
    for (int other = 0; other < index; ++other) {
      const auto largest = farthest_apart<Scalar>(
          &entry(found.configurations, index), &entry(found.configurations, other),
          SortsOf<typename Model::template Configuration<Scalar>>::count);
      // This is 1e-7 in double, and the same multiple of the square root of epsilon in another
      // scalar.
      if (largest < static_cast<Scalar>(1e-7 * 0x1p26) * numeric::half_of_digits<Scalar>) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace assur::detail
