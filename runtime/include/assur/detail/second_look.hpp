// A sharper estimate of the errors of derivatives, for configurations that their pivots call
// near-singular.
//
// The margin of the pivots is a product of factors that need not be small together, so for larger
// groups it is a hundred times too cautious. Double has digits to spare for that, float has none.
#pragma once

#include <algorithm>
#include <assur/detail/index.hpp>
#include <assur/detail/pivots.hpp>
#include <assur/detail/products.hpp>
#include <assur/detail/small_step.hpp>
#include <assur/model.hpp>
#include <assur/status.hpp>
#include <assur/support/scale.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <limits>
#include <type_traits>

namespace assur::detail {

/// The residual that polishing may leave of closures whose longest number is `longest`.
template <typename Scalar>
[[nodiscard]] Scalar polished_rounding(Scalar longest) {
  return 18 * std::numeric_limits<Scalar>::epsilon() * longest;
}

/// A residual of some epsilons in a closure f_i moves the configuration by dq = J^-1 df and the
/// derivatives J^-1 c by J^-1 (J_q dq) J^-1 c; rounding of J moves them by |J^-1| |J| |J^-1|. The
/// elimination determines the core's unknowns to a few epsilons over the ratio of the core's
/// determinant to the size of its terms; the others are differences of these divided by pivots
/// outside the core, of which the smallest counts. The margin has both of these factors, besides
/// the firmness. Lengths are divided by the group's longest. The changes by all closures add up,
/// relative to the largest entry of J^-1 among unknowns of one unit. `displaced` as in
/// `regularity`. Sets the status, the firmness, and the rounding from which `error` follows.
template <typename Model, typename Scalar>
void look_again(const typename Model::template Dimensions<Scalar>& d,
                const typename Model::template Inputs<Scalar>& u,
                const typename Model::template Configuration<Scalar>& q, Scalar displaced,
                const Firmness<Scalar>& pivots, Regularity<Scalar>& regularity) {
  constexpr int size = Model::unknown_count;
  using Square = Matrix<Scalar, size, size>;
  constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  const Scalar longest = support::own_size<Model, Scalar>(d, u);
  const auto unit = [longest](int unknown) {
    return is_angle<Model>(unknown) ? Scalar(1) : longest;
  };
  const auto jacobian_at = [&](const auto& place) {
    Square J;
    Model::jacobian(d, u, place, J);
    for (int column = 0; column < size; ++column) {
      for (int row = 0; row < size; ++row) {
        J(row, column) *= unit(column) / longest;
      }
    }
    return J;
  };
  const Square J = jacobian_at(q);
  Square inverse;
  Model::inverse_jacobian(d, u, q, inverse);
  Square sizes;  // of the entries of J^-1
  Square terms;  // of the entries of J
  for (int column = 0; column < size; ++column) {
    for (int row = 0; row < size; ++row) {
      inverse(row, column) *= longest / unit(row);
      sizes(row, column) = std::abs(inverse(row, column));
      terms(row, column) = std::abs(J(row, column));
    }
  }
  // A displacement may be longer than the group, and its rounding grows with it.
  const Scalar of_closures = polished_rounding((std::max)(Scalar(1), longest_length(q) / longest));
  constexpr Scalar of_entries = 4 * epsilon;
  constexpr Scalar of_elimination = 4 * epsilon;
  constexpr Scalar small_turn = Scalar(1) / 32;
  Square change = product(product(sizes, terms), sizes);
  for (int index = 0; index < size * size; ++index) {
    change.data()[index] *= of_entries;
  }
  for (int closure = 0; closure < size; ++closure) {
    Scalar most(0);
    for (int row = 0; row < size; ++row) {
      most = (std::max)(most, sizes(row, closure));
    }
    Vector<Scalar, size> step;
    for (int row = 0; row < size; ++row) {
      step(row) = small_turn / most * inverse(row, closure) * unit(row);
    }
    auto moved = q;
    nudge<Model, Scalar>(moved, step);
    Square slope = jacobian_at(moved);
    for (int index = 0; index < size * size; ++index) {
      slope.data()[index] -= J.data()[index];
    }
    const Square by = product(product(inverse, slope), inverse);
    const Scalar scale = (of_closures + displaced) * most / small_turn;
    for (int index = 0; index < size * size; ++index) {
      change.data()[index] += scale * std::abs(by.data()[index]);
    }
  }
  Scalar error(0);
  Scalar loose(1);
  for (const bool angles : {true, false}) {
    Scalar largest(0);
    Scalar farthest(0);
    for (int row = 0; row < size; ++row) {
      if (is_angle<Model>(row) == angles) {
        Scalar sum(0);
        for (int column = 0; column < size; ++column) {
          largest = (std::max)(largest, sizes(row, column));
          // NaN counts as an unbounded error.
          farthest = !(change(row, column) <= farthest) ? change(row, column) : farthest;
          sum += sizes(row, column);
        }
        loose = (std::max)(loose, sum);
      }
    }
    error = largest > 0 && !(farthest / largest <= error) ? farthest / largest : error;
  }
  error += of_elimination / (pivots.kept * pivots.other);
  if (std::isfinite(error)) {
    regularity.rounding = error * regularity.margin;
    regularity.firmness = (std::max)(regularity.firmness, 1 / loose);
    regularity.status = error < Scalar(regular_error<Scalar>) ? Status::ok : Status::near_singular;
  }
}

/// Whether the closures of a model are those of a group's loops, which are lengths. Closures typed
/// by a user may have any unit.
template <typename Model, typename = void>
inline constexpr bool closes_loops = false;
template <typename Model>
inline constexpr bool closes_loops<Model, std::void_t<decltype(Model::max_configurations)>> = true;

/// The regularity of a configuration by its pivots and, in float, if these do not call it regular,
/// by `look_again`.
template <typename Model, typename Scalar>
[[nodiscard, gnu::always_inline]] inline Regularity<Scalar> regularity_at(
    const Pivots<Model, Scalar>& pivots, const typename Model::template Dimensions<Scalar>& d,
    const typename Model::template Inputs<Scalar>& u,
    const typename Model::template Configuration<Scalar>& q, Scalar displaced = Scalar(0)) {
  const Firmness<Scalar> firmness = firmness_of(pivots);
  Regularity<Scalar> result =
      regularity_of(firmness, Scalar(derivative_rounding<Scalar>() + displaced));
  if constexpr (std::is_same_v<Scalar, float> && closes_loops<Model>) {
    if (result.status == Status::near_singular) {
      look_again<Model, Scalar>(d, u, q, displaced, firmness, result);
    }
  }
  return result;
}

}  // namespace assur::detail
