// Continuation of a branch beyond a singular point at which branches cross.
#pragma once

#include <algorithm>

namespace assur::local {

/// Limits within which a branch is continued across a crossing.
template <typename Scalar>
struct CrossingLimits {
  /// The point at which a rank is lost is predicted along the tangent, and a curved branch reaches
  /// it earlier or later. Ranks count as lost together if the distance to the last is less than
  /// this many times the distance to the first; with a wrong number of ranks no singular point is
  /// found.
  Scalar together = static_cast<Scalar>(1.7);
  /// The largest deviation of the path to a crossing from its tangent, divided by its length: the
  /// prediction beyond the crossing is then off by about the square of this ratio.
  Scalar bend = static_cast<Scalar>(0.1);
  /// The largest correction of the prediction, divided by the distance of the nearest other branch:
  /// half of the distance within which Newton's method is sure to converge to the nearer branch.
  Scalar correction = static_cast<Scalar>(0.25);
};

/// Finds the step `on` from a crossing onto the branch beyond it, `ratio` times as long as the step
/// `way` from the branch to the crossing. It lies on the parabola that has the branch's tangent and
/// passes through the crossing; `straight` is the step of the same length along the tangent.
/// Returns whether `way - straight` is small against `way`; a `way` shorter than `least` counts as
/// that long.
template <typename Step, typename Scalar>
[[nodiscard]] bool goes_on_behind(const Step& way, const Step& straight, Scalar ratio, Scalar least,
                                  Step& on) {
  const Step bend = way - straight;
  on = ratio * (way + bend) + ratio * ratio * bend;
  return bend.norm() <= CrossingLimits<Scalar>().bend * (std::max)(Scalar(way.norm()), least);
}

}  // namespace assur::local
