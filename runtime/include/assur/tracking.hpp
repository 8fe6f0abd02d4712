// Turns a configuration of moving inputs into that of the same branch further on.
#pragma once

#include <algorithm>
#include <assur/branch_point.hpp>
#include <assur/detail/branch_step.hpp>
#include <assur/status.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <limits>

namespace assur {

/// How far a branch was followed.
template <typename Model>
struct Track {
  /// ok: `point` is the branch's at the end of the way. no_convergence: within 0.2% of the way from
  /// `reached` the branch ends or comes too close to another; what follows is for `assemblies` to
  /// say. not_finite: a dimension, an end of the way, or the inputs next to `reached` are. Or the
  /// status of a start that is not solvable.
  Status status = Status::singular;
  double reached = 0;        ///< the parameter at `point`
  BranchPoint<Model> point;  ///< the last that is certainly of the branch; the start if none is
};

/// Follows a branch from its point `start` at the parameter `from` to the parameter `to`;
/// `path(value)` gives the inputs' motion, an InputMotion, at a value between them. `d` is what
/// `branch_point` had.
///
/// Steps are shortened until prediction, correction and the derivatives at both ends agree. A
/// change to a branch that this one could meet would show in the sign of det J; that other branches
/// are far enough away is experience, not proof: docs/performance.md counts.
template <typename Model, typename Path>
[[nodiscard]] Track<Model> track(const typename Model::template Dimensions<double>& d,
                                 const Path& path, double from, double to,
                                 const BranchPoint<Model>& start) {
  Track<Model> way{start.status, from, start};
  if (!is_solvable(start.status)) {
    return way;
  }
  if (!std::isfinite(to - from)) {
    way.status = Status::not_finite;
    return way;
  }
  const double longest = longest_length(d);
  const double inverse_size = longest > 0 ? 1 / longest : (std::numeric_limits<double>::max)();
  const double shortest = std::abs(to - from) * detail::StepLimits().shortest;
  double width = to - from;
  // Where a step was refused the branch may end. It does so like a square root of what is left of
  // the way, which is its first derivative over twice its second. The next step goes most of that.
  const auto before_end = [&](double step) {
    const auto& motion = way.point.motion;
    const double left = detail::turn_of<Model>(motion.velocity, inverse_size) /
                        (2 * detail::turn_of<Model>(motion.acceleration, inverse_size));
    const double most = (std::max)(0.75 * left, 1.5 * shortest);
    return std::copysign((std::min)(std::abs(step), most), step);
  };
  bool halved = false;
  while (way.reached != to) {
    const double rest = std::abs(to - way.reached);
    const double next = rest <= std::abs(width) ? to : way.reached + width;
    const InputMotion<Model> inputs = path(next);
    BranchPoint<Model> end;
    if (detail::step_along<Model>(d, inputs, next - way.reached, inverse_size, way.point, end)) {
      way.point = end;
      way.reached = next;
      width = halved ? before_end(width) : 2 * width;
      halved = false;
      continue;
    }
    // What is no number makes no step, so it is looked for only where one was refused.
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
