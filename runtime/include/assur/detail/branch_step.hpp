// A step along a branch, refused if its end may lie on another branch.
#pragma once

#include <algorithm>
#include <assur/branch_point.hpp>
#include <assur/detail/index.hpp>
#include <assur/detail/pivots.hpp>
#include <assur/detail/products.hpp>
#include <assur/kinematics.hpp>
#include <assur/numeric/precision.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace assur::detail {

/// The largest entry of a step, or NaN if there is one; lengths are divided by the group's size.
template <typename Model, typename Scalar>
[[nodiscard]] Scalar turn_of(const Vector<Scalar, Model::unknown_count>& step,
                             Scalar inverse_size) {
  Scalar largest = 0;
  for (int index = 0; index < Model::unknown_count; ++index) {
    const Scalar turn = std::abs(step(index)) * (is_angle<Model>(index) ? Scalar(1) : inverse_size);
    if (turn > largest || std::isnan(turn)) {
      largest = turn;
    }
  }
  return largest;
}

/// A turn of at most 0.4 radians by the first terms of its sine and cosine. The sum of their
/// squares is off by at most 1e-5. Normalising leaves about the square of that error, and
/// normalising again after the next, small turn leaves none.
template <typename Scalar>
inline void turn_slightly(Direction<Scalar>& direction, Scalar angle) {
  const Scalar square = angle * angle;
  const Scalar cosine = 1 - square * (Scalar(1) / 2 - square * (Scalar(1) / 24));
  const Scalar sine = angle * (1 - square * (Scalar(1) / 6 - square * (Scalar(1) / 120)));
  direction = normalised(turned(direction, {cosine, sine}));
}
template <typename Scalar>
inline void turn_slightly(Scalar& length, Scalar step) {
  length += step;
}

template <typename Model, typename Scalar>
void move_slightly(typename Model::template Configuration<Scalar>& q,
                   const Vector<Scalar, Model::unknown_count>& step) {
  for_each_member(q, [&step](auto& member, std::size_t index) {
    turn_slightly(member, step(static_cast<Eigen::Index>(index)));
  });
}

/// Limits within which the end of a step is accepted as a point of the same branch.
template <typename Scalar>
struct StepLimits {
  using Limits = std::numeric_limits<Scalar>;
  Scalar prediction = Scalar(0.4);   ///< the largest predicted turn, radians
  Scalar correction = Scalar(0.2);   ///< the largest first correction of the prediction, radians
  Scalar contraction = Scalar(0.3);  ///< the largest ratio of a correction to the previous one
  /// The largest deviation of the step from the derivatives at both ends, radians.
  Scalar defect = Scalar(0.03);
  /// A correction this small is the last: the remaining error is about its square, a rounding.
  Scalar settled = (std::max)(Scalar(1e-7), numeric::half_of_digits<Scalar>);
  /// After a correction this small the same inverse serves for the last one: the remaining error is
  /// about its cube.
  Scalar nearly_settled =
      (std::max)(Scalar(2e-5), numeric::power_of_two<Scalar>(-Limits::digits / 3));
  /// The shortest step, as a fraction of the requested path. The last refused step is at most twice
  /// as long, and in all measurements the branch ended within twice that step: within 0.2%.
  Scalar shortest = Scalar(5e-4);
};

/// Applies the prediction to a configuration and corrects it by Newton's steps; `way` is the total
/// step, `inverse` J^-1 before the last step. False if the prediction or the corrections are too
/// long to stay on a branch.
template <typename Model, typename Scalar>
[[nodiscard, gnu::always_inline]] inline bool predict_and_correct(
    const typename Model::template Dimensions<Scalar>& d,
    const typename Model::template Inputs<Scalar>& u, Scalar inverse_size,
    const Vector<Scalar, Model::unknown_count>& predicted,
    typename Model::template Configuration<Scalar>& q, Vector<Scalar, Model::unknown_count>& way,
    Matrix<Scalar, Model::unknown_count, Model::equation_count>& inverse) {
  constexpr StepLimits<Scalar> limits;
  using Unknowns = Vector<Scalar, Model::unknown_count>;
  if (!(turn_of<Model, Scalar>(predicted, inverse_size) < limits.prediction)) {
    return false;
  }
  move_slightly<Model, Scalar>(q, predicted);
  way = predicted;
  Vector<Scalar, Model::equation_count> f;
  for (Scalar limit = limits.correction;;) {
    Model::residual(d, u, q, f);
    Model::inverse_jacobian(d, u, q, inverse);
    const Unknowns step = -product(inverse, f);
    const Scalar turn = turn_of<Model, Scalar>(step, inverse_size);
    if (!(turn <= (std::max)(limit, limits.settled))) {
      return false;
    }
    move_slightly<Model, Scalar>(q, step);
    way += step;
    if (turn <= limits.settled) {
      return true;
    }
    limit = limits.contraction * turn;
    if (turn <= limits.nearly_settled) {
      // A further correction with the same inverse reduces the error by the same ratio again.
      Model::residual(d, u, q, f);
      const Unknowns rest = -product(inverse, f);
      const Scalar found = turn_of<Model, Scalar>(rest, inverse_size);
      move_slightly<Model, Scalar>(q, rest);
      way += rest;
      if (found * found <= limits.settled * limits.settled * turn) {
        return true;
      }
    }
  }
}

/// The largest difference of two lists of variables, with lengths times `inverse_size`.
template <typename Scalar, typename Variables>
[[nodiscard]] Scalar largest_difference(const Variables& one, const Variables& other,
                                        Scalar inverse_size = Scalar(1)) {
  Scalar largest = 0;
  for_each_pair(one, other, [&](const auto& x, const auto& y) {
    constexpr bool is_length = std::is_same_v<std::decay_t<decltype(x)>, Scalar>;
    largest = (std::max)(largest, apart(x, y) * (is_length ? inverse_size : Scalar(1)));
  });
  return largest;
}

/// The pivots of J that extrapolation from one end predicts to vanish within twice a step. `beside`
/// are the inputs after a small part of the step, `pivots_beside` the pivots there. If the inputs
/// start from rest, turn back or go round in a circle, so that their tangent and their chord differ
/// by more than half of the longer one, any pivot may vanish.
template <typename Scalar, typename Inputs, typename Values>
[[nodiscard]] PivotSet pivots_that_may_vanish(const Inputs& from, const Inputs& beside,
                                              const Inputs& to, const Values& pivots,
                                              const Values& pivots_beside, Scalar part) {
  Inputs straight = from;
  for_each_pair(beside, straight, [part](const auto& next, auto& member) {
    member = extrapolated(member, next, part);
  });
  const Scalar tangent = largest_difference<Scalar>(straight, from);
  const Scalar chord = largest_difference<Scalar>(to, from);
  const Scalar rounding =
      4 * std::numeric_limits<Scalar>::epsilon() * (1 + longest_length(from)) / part;
  if (!(2 * largest_difference<Scalar>(straight, to) <= (std::max)(tangent, chord) + rounding)) {
    return ~PivotSet{};
  }
  return vanishing_pivots(pivots, pivots_beside, part);
}

/// Whether no pivot can vanish within twice a step back from its end, if no member turns by more
/// than `turn` on the step and no rate changes by more than `bend` along it: a pivot's second
/// derivative is at most four times its size per square of the turn and twice its size per bend.
template <typename Model, typename Scalar>
[[nodiscard]] bool keep_their_signs(const Vector<Scalar, Model::pivot_count>& start,
                                    const Pivots<Model, Scalar>& end, Scalar turn, Scalar bend) {
  const Scalar bound = 4 * turn * turn + 2 * bend;
  bool keep = true;
  for (int index = 0; index < Model::pivot_count; ++index) {
    const Scalar value = end.values(index);
    const Scalar beyond = 2 * start(index) - value;
    keep = keep && std::copysign(beyond, value * beyond) > bound * end.sizes(index);
  }
  return keep;
}

/// Whether J may have been singular within a step: a pivot changes its sign, or extrapolation from
/// both ends predicts that it vanishes. The latter happens if the step has passed a crossing onto
/// the branch whose pivots have the same signs, or a gap in which nothing can be assembled.
template <typename Model, typename Scalar>
[[nodiscard]] bool may_pass_singularity(const typename Model::template Dimensions<Scalar>& d,
                                        const InputMotion<Model, Scalar>& from,
                                        const BranchPoint<Model, Scalar>& start,
                                        const InputMotion<Model, Scalar>& to,
                                        const BranchPoint<Model, Scalar>& end, Scalar width) {
  constexpr Scalar part = numeric::half_of_digits<Scalar>;
  const auto may_vanish = [&](const InputMotion<Model, Scalar>& inputs,
                              const BranchPoint<Model, Scalar>& point,
                              const InputMotion<Model, Scalar>& other, Scalar step) {
    auto u = inputs.u;
    auto q = point.q;
    advance(u, Vector<Scalar, Model::input_count>(step * inputs.rate));
    advance(q, Vector<Scalar, Model::unknown_count>(step * point.motion.velocity));
    return pivots_that_may_vanish<Scalar>(inputs.u, u, other.u, point.pivots,
                                          pivots_at<Model, Scalar>(d, u, q).values, part);
  };
  if (changed_pivots(start.pivots, end.pivots) != 0) {
    return true;
  }
  const PivotSet ahead = may_vanish(from, start, to, part * width);
  return ahead != 0 && (ahead & may_vanish(to, end, from, -part * width)) != 0;
}

/// One step: predicted to second order, corrected by Newton's steps. False if the end may lie on
/// another branch.
template <typename Model, typename Scalar>
[[nodiscard]] bool step_along(const typename Model::template Dimensions<Scalar>& d,
                              const InputMotion<Model, Scalar>& from,
                              const InputMotion<Model, Scalar>& inputs, Scalar width,
                              Scalar inverse_size, const BranchPoint<Model, Scalar>& start,
                              BranchPoint<Model, Scalar>& end) {
  using Unknowns = Vector<Scalar, Model::unknown_count>;
  const Unknowns predicted =
      width * start.motion.velocity + width * width / 2 * start.motion.acceleration;
  Unknowns way;
  Matrix<Scalar, Model::unknown_count, Model::equation_count> inverse;
  end.q = start.q;
  if (!predict_and_correct<Model, Scalar>(d, inputs.u, inverse_size, predicted, end.q, way,
                                          inverse)) {
    return false;
  }
  const Pivots<Model, Scalar> pivots = pivots_at<Model, Scalar>(d, inputs.u, end.q);
  const Regularity<Scalar> regularity = regularity_at<Model, Scalar>(pivots, d, inputs.u, end.q);
  if (!regularity.knows_velocities()) {
    return false;
  }
  end.status = regularity.status;
  end.pivots = pivots.values;
  Model::motion(d, inputs.u, end.q, inputs.rate, inputs.second_rate, end.motion.velocity,
                end.motion.acceleration);
  const Unknowns defect =
      way - width / 2 * (start.motion.velocity + end.motion.velocity) -
      width * width * (Scalar(1) / 12) * (start.motion.acceleration - end.motion.acceleration);
  const Scalar deviation = turn_of<Model, Scalar>(defect, inverse_size);
  if (!(deviation <= StepLimits<Scalar>().defect)) {
    return false;
  }
  auto straight = from.u;
  advance(straight, Vector<Scalar, Model::input_count>(width * from.rate));
  const Scalar turn = (std::max)(turn_of<Model, Scalar>(way, inverse_size),
                                 largest_difference<Scalar>(from.u, inputs.u, inverse_size));
  const Unknowns change = width * (end.motion.velocity - start.motion.velocity);
  const Scalar bend = turn_of<Model, Scalar>(change, inverse_size) + deviation +
                      largest_difference<Scalar>(straight, inputs.u, inverse_size);
  return keep_their_signs<Model, Scalar>(start.pivots, pivots, turn + bend, bend) ||
         !may_pass_singularity<Model, Scalar>(d, from, start, inputs, end, width);
}

}  // namespace assur::detail
