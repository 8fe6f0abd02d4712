// Start of a branch, and points of a branch: configurations with derivatives and pivots.
#pragma once

#include <assur/detail/pivots.hpp>
#include <assur/kinematics.hpp>
#include <assur/status.hpp>

namespace assur {

/// The values of a model's inputs and their derivatives with respect to a parameter.
template <typename Model, typename Scalar = double>
struct InputMotion {
  typename Model::template Inputs<Scalar> u;
  Vector<Scalar, Model::input_count> rate;
  Vector<Scalar, Model::input_count> second_rate;
};

/// A point of a branch: a configuration and its derivatives with respect to the parameter.
template <typename Model, typename Scalar = double>
struct BranchPoint {
  /// ok; near_singular if the derivatives may have fewer correct digits than `regularity` promises.
  /// With any other status there are no derivatives, and no branch can be tracked from here.
  /// singular also if velocities are undetermined: the branch may be any of those that meet there.
  Status status = Status::singular;
  typename Model::template Configuration<Scalar> q;
  Motion<Model, Scalar> motion;  ///< set if the status is ok or near_singular
  /// The pivots of the structured elimination: if one vanishes, J is singular, and this branch may
  /// meet others. Zero unless the status is ok or near_singular.
  Vector<Scalar, Model::pivot_count> pivots = Vector<Scalar, Model::pivot_count>::Zero();
};

/// The start of a branch: a configuration from `assemblies` or `refine`, F(d, u, q) = 0, with its
/// derivatives q' = dq/dt and q'' for inputs that depend on a parameter t.
template <typename Model, typename Scalar = double>
[[nodiscard]] BranchPoint<Model, Scalar> branch_point(
    const typename Model::template Dimensions<Scalar>& d, const InputMotion<Model, Scalar>& inputs,
    const typename Model::template Configuration<Scalar>& q) {
  static_assert(Model::rigid, "a degenerate model has no inverse Jacobian");
  BranchPoint<Model, Scalar> point;
  point.q = q;
  if (!is_finite(d) || !is_finite(inputs.u) || !is_finite(q) || !is_finite(inputs.rate) ||
      !is_finite(inputs.second_rate)) {
    point.status = Status::not_finite;
    return point;
  }
  const auto pivots = detail::pivots_at<Model, Scalar>(d, inputs.u, q);
  const Regularity<Scalar> regularity =
      detail::regularity_at<Model, Scalar>(pivots, d, inputs.u, q);
  if (regularity.knows_velocities()) {
    point.status = regularity.status;
    Model::motion(d, inputs.u, q, inputs.rate, inputs.second_rate, point.motion.velocity,
                  point.motion.acceleration);
    point.pivots = pivots.values;
  }
  return point;
}

}  // namespace assur
