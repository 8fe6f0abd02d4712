// Continuation of a configuration along its branch while the inputs move.
#pragma once

#include <algorithm>
#include <assur/branch_point.hpp>
#include <assur/detail/branch_step.hpp>
#include <assur/status.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <limits>
#include <type_traits>

namespace assur {

/// The result of following a branch.
template <typename Model, typename Scalar = double>
struct Track {
  /// ok: `point` is the point of the branch at `to`. no_convergence: within 0.2% of the path beyond
  /// `reached` the branch ends or comes too close to another; `assemblies` finds the configurations
  /// there. not_finite: a dimension, an end of the path, or the inputs next to `reached` are not
  /// finite. Otherwise the status of a start that is not solvable.
  Status status = Status::singular;
  Scalar reached = 0;  ///< the parameter at `point`
  BranchPoint<Model, Scalar>
      point;  ///< the last point certain to lie on the branch; otherwise the start
};

/// Follows a branch from its point `start` at the parameter `from` to the parameter `to`;
/// `path(value)` returns the InputMotion at a value between them. `d` are the dimensions given to
/// `branch_point`.
///
/// Steps are shortened until prediction, correction and the derivatives at both ends agree. A jump
/// to a branch that can meet this one would change the sign of det J; that other branches are far
/// enough away is tested, not proved (docs/reports/performance.md).
template <typename Model, typename Scalar = double, typename Path>
[[nodiscard]] Track<Model, Scalar> track(const typename Model::template Dimensions<Scalar>& d,
                                         const Path& path, std::common_type_t<Scalar> from,
                                         std::common_type_t<Scalar> to,
                                         const BranchPoint<Model, Scalar>& start) {
  Track<Model, Scalar> way{start.status, from, start};
  if (!is_solvable(start.status)) {
    return way;
  }
  if (!std::isfinite(to - from)) {
    way.status = Status::not_finite;
    return way;
  }
  const Scalar longest = longest_length(d);
  const Scalar inverse_size = longest > 0 ? 1 / longest : (std::numeric_limits<Scalar>::max)();
  // A shorter step might leave a parameter of this size unchanged.
  const Scalar shortest = (std::max)(
      std::abs(to - from) * detail::StepLimits<Scalar>().shortest,
      2 * std::numeric_limits<Scalar>::epsilon() * (std::max)(std::abs(from), std::abs(to)));
  Scalar width = to - from;
  InputMotion<Model, Scalar> reached_inputs = path(from);
  // A refused step may mean that the branch ends, like the square root of the remaining distance.
  // That distance is its first derivative over twice its second; the next step covers most of it.
  const auto before_end = [&](Scalar step) {
    const auto& motion = way.point.motion;
    const Scalar left = detail::turn_of<Model, Scalar>(motion.velocity, inverse_size) /
                        (2 * detail::turn_of<Model, Scalar>(motion.acceleration, inverse_size));
    const Scalar most = (std::max)(Scalar(0.75) * left, Scalar(1.5) * shortest);
    return std::copysign((std::min)(std::abs(step), most), step);
  };
  // Inputs at rest in the same position at both ends of a step may have made a full turn in
  // between.
  const auto goes_round = [&](const InputMotion<Model, Scalar>& there, Scalar next) {
    const auto stays = [&reached_inputs](const auto& u) {
      return detail::largest_difference<Scalar>(reached_inputs.u, u) <=
             4 * std::numeric_limits<Scalar>::epsilon() * (1 + longest_length(u));
    };
    return reached_inputs.rate.isZero(0) && there.rate.isZero(0) && stays(there.u) &&
           !stays(path(way.reached + (next - way.reached) / 2).u);
  };
  bool halved = false;
  while (way.reached != to) {
    const Scalar rest = std::abs(to - way.reached);
    const Scalar next = rest <= std::abs(width) ? to : way.reached + width;
    const InputMotion<Model, Scalar> inputs = path(next);
    BranchPoint<Model, Scalar> end;
    if (!goes_round(inputs, next) &&
        detail::step_along<Model, Scalar>(d, reached_inputs, inputs, next - way.reached,
                                          inverse_size, way.point, end)) {
      way.point = end;
      way.reached = next;
      reached_inputs = inputs;
      width = halved ? before_end(width) : 2 * width;
      halved = false;
      continue;
    }
    // A step with values that are not finite is refused, so they are checked only after a refusal.
    if (!is_finite(d) || !is_finite(inputs.u) || !is_finite(inputs.rate) ||
        !is_finite(inputs.second_rate)) {
      way.status = Status::not_finite;
      return way;
    }
    width = before_end((next - way.reached) / 2);
    halved = true;
    if (!(std::abs(width) > shortest)) {
      way.status = Status::no_convergence;
      return way;
    }
  }
  way.status = Status::ok;
  return way;
}

}  // namespace assur
