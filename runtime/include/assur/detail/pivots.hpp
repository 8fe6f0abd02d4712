// Pivots of a model's structured elimination: regularity of a configuration, and singularities
// between two.
#pragma once

#include <assur/model.hpp>
#include <assur/numeric/precision.hpp>
#include <assur/status.hpp>
#include <assur/support/derivative_digits.hpp>
#include <cmath>
#include <limits>

namespace assur::detail {

/// The pivots at a configuration, the upper bound of each, and the size of the terms of the core's
/// determinant.
template <typename Model, typename Scalar>
struct Pivots {
  Vector<Scalar, Model::pivot_count> values;
  Vector<Scalar, Model::pivot_count> sizes;
  Scalar terms = Scalar(0);
};

template <typename Model, typename Scalar>
[[nodiscard]] Pivots<Model, Scalar> pivots_at(
    const typename Model::template Dimensions<Scalar>& d,
    const typename Model::template Inputs<Scalar>& u,
    const typename Model::template Configuration<Scalar>& q) {
  Pivots<Model, Scalar> pivots;
  Model::degeneracies(d, u, q, pivots.values, pivots.sizes, pivots.terms);
  return pivots;
}

using support::derivative_rounding;
using support::regular_error;

/// Measures from the pivots, relative to their upper bounds.
template <typename Scalar>
struct Firmness {
  Scalar kept;      ///< the core's determinant, divided by the size of its terms
  Scalar core;      ///< the product of the core's pivots
  Scalar other;     ///< the smallest of the others
  int weakest = 0;  ///< index in Model::pivots of the pivot nearest to zero
};

template <typename Model, typename Scalar>
[[nodiscard, gnu::always_inline]] inline Firmness<Scalar> firmness_of(
    const Pivots<Model, Scalar>& pivots) {
  using std::abs;
  Firmness<Scalar> result{Scalar(1), Scalar(1), Scalar(1)};
  Scalar smallest = std::numeric_limits<Scalar>::infinity();
  for (int index = 0; index < Model::pivot_count; ++index) {
    const Scalar value = abs(pivots.values(index));
    const Scalar firmness = value / pivots.sizes(index);
    if (index < Model::core_pivot_count) {
      result.kept = result.kept * value;
      result.core = result.core * firmness;
    } else if (!(firmness >= result.other)) {
      result.other = firmness;
    }
    if (!(firmness >= smallest)) {
      smallest = firmness;
      result.weakest = index;
    }
  }
  result.kept = result.kept / pivots.terms;
  return result;
}

/// `rounding` is the relative error of the quantities from which the pivots are computed, constants
/// included. The result depends on the product of the core's pivots and the smallest of the others.
template <typename Scalar>
[[nodiscard]] Regularity<Scalar> regularity_of(const Firmness<Scalar>& pivots,
                                               const Scalar& rounding) {
  Regularity<Scalar> result;
  result.weakest = pivots.weakest;
  const Scalar firmness = pivots.core * pivots.other * pivots.other;
  const Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  if (!(pivots.kept > epsilon && firmness > Scalar(0))) {
    return result;
  }
  result.margin = pivots.kept * firmness;
  result.firmness = firmness;
  result.rounding = rounding;
  const bool keeps = rounding < Scalar(regular_error<Scalar>) * result.margin;
  result.status = keeps ? Status::ok : Status::near_singular;
  return result;
}

/// Whether `regularity_of` returns ok, without a division: every other pivot is tried as the
/// smallest.
template <typename Model, typename Scalar, typename Rounding>
[[nodiscard]] auto are_regular(const Pivots<Model, Scalar>& pivots, const Rounding& rounding) {
  auto core = Scalar(regular_error<typename numeric::PartOf<Scalar>::Type>);
  Scalar lost = Scalar(rounding) * pivots.terms;
  for (int index = 0; index < Model::core_pivot_count; ++index) {
    core = core * (pivots.values(index) * pivots.values(index));
    lost = lost * pivots.sizes(index);
  }
  auto regular = lost < core;
  for (int index = Model::core_pivot_count; index < Model::pivot_count; ++index) {
    regular = regular & (lost * (pivots.sizes(index) * pivots.sizes(index)) <
                         core * (pivots.values(index) * pivots.values(index)));
  }
  return regular;
}

/// Whether the above holds for all numbers of a pack.
template <typename Model, typename Scalar>
[[nodiscard]] bool is_regular(const Pivots<Model, Scalar>& pivots,
                              typename numeric::PartOf<Scalar>::Type rounding) {
  return static_cast<bool>(are_regular<Model>(pivots, rounding));
}

/// Whether second rates also have as many digits, for any motion of the inputs: they divide by the
/// firmness once more (see `second_rate_error`). Without a division, as above.
template <typename Model, typename Scalar>
[[nodiscard]] auto is_firm(const Pivots<Model, Scalar>& pivots, const Scalar& rounding) {
  using std::abs;
  Scalar core(1);
  Scalar sizes(1);
  for (int index = 0; index < Model::core_pivot_count; ++index) {
    core = core * abs(pivots.values(index));
    sizes = sizes * pivots.sizes(index);
  }
  core = core * (Scalar(regular_error<typename numeric::PartOf<Scalar>::Type>) * core * core);
  const Scalar lost = rounding * pivots.terms * sizes * sizes;
  auto firm = lost < core;
  for (int index = Model::core_pivot_count; index < Model::pivot_count; ++index) {
    const Scalar value = pivots.values(index) * pivots.values(index);
    const Scalar size = pivots.sizes(index) * pivots.sizes(index);
    firm = firm & (lost * (size * size) < core * (value * value));
  }
  return firm;
}

/// A set of pivots has a bit for each.
using PivotSet = unsigned;

/// The pivots that change their sign between two points, or vanish at one: J is singular between.
template <typename Values>
[[nodiscard]] PivotSet changed_pivots(const Values& one, const Values& other) {
  PivotSet changed = 0;
  for (Eigen::Index index = 0; index < one.size(); ++index) {
    changed |= static_cast<PivotSet>(!(one(index) * other(index) > 0)) << index;
  }
  return changed;
}

/// The pivots that vanish within twice a step by linear extrapolation; `beside` are the pivots
/// after the fraction `part` of the step. Twice, since a pivot may vanish close to the step's end,
/// where the extrapolation has an error of the square of the step.
template <typename Values>
[[nodiscard]] PivotSet vanishing_pivots(const Values& at, const Values& beside,
                                        typename Values::Scalar part) {
  return changed_pivots<Values>(at, part * at + 2 * (beside - at));
}

}  // namespace assur::detail
