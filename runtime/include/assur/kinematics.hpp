// First-order kinematics of an assembled configuration: regularity, sensitivities, rates and
// Newton's method.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <assur/detail/index.hpp>
#include <assur/detail/limit_turns.hpp>
#include <assur/detail/pivots.hpp>
#include <assur/detail/products.hpp>
#include <assur/detail/second_look.hpp>
#include <assur/model.hpp>
#include <assur/status.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <limits>

namespace assur {

/// The regularity of an assembled configuration, without an inverse or singular values.
///
/// Rounding moves an assembled configuration by about eps/firmness. Firmness is the core's
/// determinant over its largest possible size, times the square of the smallest other pivot over
/// the square of its largest possible size: a small pivot makes an unknown large, and so its
/// rounding. That, and rounding in the determinant, change the derivatives by about eps/(firmness *
/// kept), where kept is the determinant over the size of its terms. `derivative_error_constant` is
/// the measured factor of "about". `displaced` is the error of the inputs, divided by the group's
/// longest length: in a chain, that from the preceding groups.
///
/// `ok` promises six digits of the derivatives in double, three in float. In float, configurations
/// that are not regular by the pivots are examined again (see detail/second_look.hpp).
template <typename Model, typename Scalar>
[[nodiscard]] Regularity<Scalar> regularity(const typename Model::template Dimensions<Scalar>& d,
                                            const typename Model::template Inputs<Scalar>& u,
                                            const typename Model::template Configuration<Scalar>& q,
                                            const Scalar& displaced = Scalar(0)) {
  static_assert(Model::rigid, "a degenerate model has no inverse Jacobian");
  if (!is_finite(d) || !is_finite(u) || !is_finite(q)) {
    return {Status::not_finite};
  }
  return detail::regularity_at<Model, Scalar>(detail::pivots_at<Model, Scalar>(d, u, q), d, u, q,
                                              displaced);
}

/// The inverse of the loop Jacobian J = dF/dq, for any right-hand side. Its status applies to all
/// solutions computed with it.
template <typename Model, typename Scalar>
class InverseJacobian {
 public:
  static constexpr int size = Model::unknown_count;

  /// `displaced` as in `regularity`.
  InverseJacobian(const typename Model::template Dimensions<Scalar>& d,
                  const typename Model::template Inputs<Scalar>& u,
                  const typename Model::template Configuration<Scalar>& q,
                  const Scalar& displaced = Scalar(0))
      : regularity_(assur::regularity<Model, Scalar>(d, u, q, displaced)) {
    if (solvable()) {
      Model::inverse_jacobian(d, u, q, inverse_);
    } else {
      inverse_.setConstant(std::numeric_limits<Scalar>::quiet_NaN());
    }
  }

  [[nodiscard]] Status status() const { return regularity_.status; }
  [[nodiscard]] Scalar margin() const { return regularity_.margin; }
  /// Whether J has an inverse, certified despite rounding.
  [[nodiscard]] bool solvable() const { return is_solvable(status()); }

  /// X with J X = rhs; NaN unless solvable().
  template <int Columns>
  [[nodiscard]] Matrix<Scalar, size, Columns> solve(
      const Matrix<Scalar, size, Columns>& rhs) const {
    return detail::product(inverse_, rhs);
  }

 private:
  Regularity<Scalar> regularity_;
  Matrix<Scalar, size, size> inverse_;
};

/// dq/dd and dq/du: derivatives of an assembled configuration with respect to dimensions and
/// inputs.
template <typename Model, typename Scalar>
struct Sensitivities {
  Matrix<Scalar, Model::unknown_count, Model::dimension_count> to_dimensions;
  Matrix<Scalar, Model::unknown_count, Model::input_count> to_inputs;
};

/// Computes dq/dd and dq/du of an assembled configuration. The result is set if the status is ok
/// or near_singular.
template <typename Model, typename Scalar>
[[nodiscard]] Status sensitivities(const typename Model::template Dimensions<Scalar>& d,
                                   const typename Model::template Inputs<Scalar>& u,
                                   const typename Model::template Configuration<Scalar>& q,
                                   Sensitivities<Model, Scalar>& result) {
  const Status status = regularity<Model, Scalar>(d, u, q).status;
  if (is_solvable(status)) {
    Model::sensitivities(d, u, q, result.to_dimensions, result.to_inputs);
  }
  return status;
}

/// The status of a configuration whose inputs move: not_finite if a rate is NaN or infinite.
template <typename Model, typename Scalar>
[[nodiscard]] Status status_of(const typename Model::template Dimensions<Scalar>& d,
                               const typename Model::template Inputs<Scalar>& u,
                               const typename Model::template Configuration<Scalar>& q,
                               const Vector<Scalar, Model::input_count>& u_rate,
                               const Vector<Scalar, Model::input_count>& u_second_rate) {
  if (!is_finite(u_rate) || !is_finite(u_second_rate)) {
    return Status::not_finite;
  }
  return regularity<Model, Scalar>(d, u, q).status;
}

/// Rates of motion: dq/dt and d2q/dt2.
template <typename Model, typename Scalar>
struct Motion {
  Vector<Scalar, Model::unknown_count> velocity;
  Vector<Scalar, Model::unknown_count> acceleration;
};

/// dq/dt and d2q/dt2 for the first and second rates of the inputs, at constant dimensions. The
/// result is set if the status is ok or near_singular.
template <typename Model, typename Scalar>
[[nodiscard]] Status motion(const typename Model::template Dimensions<Scalar>& d,
                            const typename Model::template Inputs<Scalar>& u,
                            const typename Model::template Configuration<Scalar>& q,
                            const Vector<Scalar, Model::input_count>& u_rate,
                            const Vector<Scalar, Model::input_count>& u_second_rate,
                            Motion<Model, Scalar>& result) {
  const Status status = status_of<Model, Scalar>(d, u, q, u_rate, u_second_rate);
  if (is_solvable(status)) {
    Model::motion(d, u, q, u_rate, u_second_rate, result.velocity, result.acceleration);
  }
  return status;
}

/// Computes sensitivities and motion at once, for less than the sum of their costs.
template <typename Model, typename Scalar>
[[nodiscard]] Status sensitivities_and_motion(
    const typename Model::template Dimensions<Scalar>& d,
    const typename Model::template Inputs<Scalar>& u,
    const typename Model::template Configuration<Scalar>& q,
    const Vector<Scalar, Model::input_count>& u_rate,
    const Vector<Scalar, Model::input_count>& u_second_rate,
    Sensitivities<Model, Scalar>& sensitive, Motion<Model, Scalar>& moving) {
  const Status status = status_of<Model, Scalar>(d, u, q, u_rate, u_second_rate);
  if (is_solvable(status)) {
    Model::sensitivities_and_motion(d, u, q, u_rate, u_second_rate, sensitive.to_dimensions,
                                    sensitive.to_inputs, moving.velocity, moving.acceleration);
  }
  return status;
}

/// d3q/dt3 for the third rates of the inputs, with the lower rates from `motion`. The result is set
/// if the status is ok or near_singular. The model's header must be emitted with `assur emit
/// --model N --with jerk`.
template <typename Model, typename Scalar>
[[nodiscard]] Status jerk(const typename Model::template Dimensions<Scalar>& d,
                          const typename Model::template Inputs<Scalar>& u,
                          const typename Model::template Configuration<Scalar>& q,
                          const Vector<Scalar, Model::input_count>& u_rate,
                          const Vector<Scalar, Model::input_count>& u_second_rate,
                          const Vector<Scalar, Model::input_count>& u_third_rate,
                          const Motion<Model, Scalar>& moving,
                          Vector<Scalar, Model::unknown_count>& result) {
  if (!is_finite(u_rate) || !is_finite(u_second_rate) || !is_finite(u_third_rate) ||
      !is_finite(moving.velocity) || !is_finite(moving.acceleration)) {
    return Status::not_finite;
  }
  const InverseJacobian<Model, Scalar> inverse(d, u, q);
  if (inverse.solvable()) {
    Vector<Scalar, Model::equation_count> rhs;
    Model::jerk_rhs(d, u, q, moving.velocity, moving.acceleration, u_rate, u_second_rate,
                    u_third_rate, rhs);
    result = inverse.solve(rhs);
  }
  return inverse.status();
}

/// Newton's method on the loop closures from a guess, until the step is at rounding level. An angle
/// moves by at most half a radian per step. With `ok` and `near_singular` the configuration is
/// assembled; otherwise it is the last iterate. The iteration may converge to any branch.
template <typename Model, typename Scalar>
[[nodiscard]] Status refine(const typename Model::template Dimensions<Scalar>& d,
                            const typename Model::template Inputs<Scalar>& u,
                            typename Model::template Configuration<Scalar>& q,
                            int max_iterations = 50) {
  using std::sqrt;
  constexpr int size = Model::unknown_count;
  const Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  Scalar previous = std::numeric_limits<Scalar>::infinity();
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    const InverseJacobian<Model, Scalar> jacobian(d, u, q);
    if (!jacobian.solvable()) {
      return jacobian.status();
    }
    Vector<Scalar, Model::equation_count> residual;
    Model::residual(d, u, q, residual);
    Vector<Scalar, size> step = jacobian.solve(Vector<Scalar, size>(-residual));
    Scalar largest_turn(0);
    for (int index = 0; index < size; ++index) {
      if (detail::is_angle<Model>(index)) {
        using std::abs;
        using std::max;
        largest_turn = max EIGEN_NOT_A_MACRO(largest_turn, abs(step(index)));
      }
    }
    const Scalar longest = step.cwiseAbs().maxCoeff();
    if (largest_turn > Scalar(0.5)) {
      Matrix<Scalar, Model::equation_count, size> J;
      Model::jacobian(d, u, q, J);
      detail::limit_turns<Model, Scalar>(J, step);
    }
    advance(q, step);
    // Close to the solution the steps shrink quadratically down to rounding, about eps over the
    // square root of the margin.
    const bool small = largest_turn < Scalar(1e3) * epsilon / sqrt(jacobian.margin());
    if (longest == Scalar(0) || (small && !(longest < previous / Scalar(2)))) {
      return jacobian.status();
    }
    previous = longest;
  }
  return Status::no_convergence;
}

}  // namespace assur
