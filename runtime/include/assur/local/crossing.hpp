// How a branch goes on behind a singular point at which branches cross.
#pragma once

#include <algorithm>

namespace assur::local {

/// The limits within which a branch is taken to go over a crossing.
template <typename Scalar>
struct CrossingLimits {
  /// Where a rank is lost is told from a tangent, and a bent branch comes there sooner or later.
  /// Ranks are taken to be lost together if the way to the last is less than this many times the
  /// way to the first; with a wrong number no singular point is found.
  Scalar together = static_cast<Scalar>(1.7);
  /// The largest bend of the way to a crossing, in parts of the way: what is predicted behind it is
  /// then off by about the square of this part.
  Scalar bend = static_cast<Scalar>(0.1);
  /// The largest correction of what is predicted, in parts of the distance of the nearest other
  /// branch: half of the distance within which Newton's steps are sure to lead to the nearer one.
  Scalar correction = static_cast<Scalar>(0.25);
};

/// Finds the step `on` by which a branch goes on behind a crossing, `ratio` times as far as it
/// comes: along the parabola that has the branch's tangent and leads to the crossing. `way` leads
/// there from the branch, and `straight` as far along the tangent. Returns whether the bend is
/// small in parts of the way; one that is shorter than `least` counts as that long.
template <typename Step, typename Scalar>
[[nodiscard]] bool goes_on_behind(const Step& way, const Step& straight, Scalar ratio, Scalar least,
                                  Step& on) {
  const Step bend = way - straight;
  on = ratio * (way + bend) + ratio * ratio * bend;
  return bend.norm() <= CrossingLimits<Scalar>().bend * (std::max)(Scalar(way.norm()), least);
}

}  // namespace assur::local
