// Solves a generated model's linear equations: sensitivities, velocity, acceleration, Newton steps.
#pragma once

#include <Eigen/LU>
#include <assur/model.hpp>
#include <assur/status.hpp>
#include <assur/variables.hpp>
#include <limits>

namespace assur {

/// The loop Jacobian J at one configuration, with its condition. Columns are scaled to a largest
/// entry of one, so that the condition does not depend on the unit of length.
template <typename Model, typename Scalar>
class ScaledJacobian {
  static_assert(Model::rigid, "a degenerate model has no inverse Jacobian");

 public:
  static constexpr int size = Model::unknown_count;

  /// status(): ok, near_singular (the derivatives may keep fewer than six digits), singular, or
  /// not_finite.
  ScaledJacobian(const typename Model::template Dimensions<Scalar>& d,
                 const typename Model::template Inputs<Scalar>& u,
                 const typename Model::template Configuration<Scalar>& q) {
    if (!is_finite(d) || !is_finite(u) || !is_finite(q)) {
      status_ = Status::not_finite;
      return;
    }
    Model::jacobian(d, u, q, scaled_);
    column_scale_ = scaled_.cwiseAbs().colwise().maxCoeff();
    column_scale_ = column_scale_.cwiseInverse();
    if (!column_scale_.allFinite()) {  // a column is zero, or so small that nothing is left of it
      return;
    }
    scaled_ = scaled_ * column_scale_.asDiagonal();
    // At these sizes the inverse by cofactors costs less than an estimate of its norm.
    inverse_ = scaled_.inverse();
    reciprocal_condition_ = Scalar(1) / (one_norm(scaled_) * one_norm(inverse_));
    const Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
    if (reciprocal_condition_ > epsilon) {
      status_ = reciprocal_condition_ < epsilon * Scalar(1e6) ? Status::near_singular : Status::ok;
    }
  }

  [[nodiscard]] Status status() const { return status_; }
  /// Whether J has an inverse as far as rounding lets tell.
  [[nodiscard]] bool solvable() const {
    return status_ == Status::ok || status_ == Status::near_singular;
  }
  /// Reciprocal of the condition number in the 1-norm, columns scaled; zero if unknown.
  [[nodiscard]] Scalar reciprocal_condition() const { return reciprocal_condition_; }

  /// An approximate x with J x = rhs, good for corrections. Requires solvable().
  [[nodiscard]] Vector<Scalar, size> correction(const Vector<Scalar, size>& rhs) const {
    return column_scale_.asDiagonal() * (inverse_ * rhs);
  }

 protected:
  [[nodiscard]] const Matrix<Scalar, size, size>& scaled() const { return scaled_; }
  [[nodiscard]] const Vector<Scalar, size>& column_scale() const { return column_scale_; }

 private:
  [[nodiscard]] static Scalar one_norm(const Matrix<Scalar, size, size>& matrix) {
    return matrix.cwiseAbs().colwise().sum().maxCoeff();
  }

  Status status_ = Status::singular;
  Scalar reciprocal_condition_ = Scalar(0);
  Vector<Scalar, size> column_scale_;
  Matrix<Scalar, size, size> scaled_;
  Matrix<Scalar, size, size> inverse_;
};

/// The loop Jacobian factored, for solutions as accurate as its condition allows.
template <typename Model, typename Scalar>
class FactoredJacobian : public ScaledJacobian<Model, Scalar> {
 public:
  static constexpr int size = Model::unknown_count;

  FactoredJacobian(const typename Model::template Dimensions<Scalar>& d,
                   const typename Model::template Inputs<Scalar>& u,
                   const typename Model::template Configuration<Scalar>& q)
      : ScaledJacobian<Model, Scalar>(d, u, q) {
    if (this->solvable()) {
      factors_.compute(this->scaled());
    }
  }

  /// X with J X = rhs. Requires solvable().
  template <int Columns>
  [[nodiscard]] Matrix<Scalar, size, Columns> solve(
      const Matrix<Scalar, size, Columns>& rhs) const {
    return this->column_scale().asDiagonal() * factors_.solve(rhs);
  }

 private:
  Eigen::PartialPivLU<Matrix<Scalar, size, size>> factors_;
};

/// dq/dd and dq/du: how an assembled configuration follows the dimensions and the inputs.
template <typename Model, typename Scalar>
struct Sensitivities {
  Matrix<Scalar, Model::unknown_count, Model::dimension_count> to_dimensions;
  Matrix<Scalar, Model::unknown_count, Model::input_count> to_inputs;
};

/// Solves J dq/dd = -F_d and J dq/du = -F_u. The result is set where the status is ok or
/// near_singular.
template <typename Model, typename Scalar>
[[nodiscard]] Status sensitivities(const typename Model::template Dimensions<Scalar>& d,
                                   const typename Model::template Inputs<Scalar>& u,
                                   const typename Model::template Configuration<Scalar>& q,
                                   Sensitivities<Model, Scalar>& result) {
  const FactoredJacobian<Model, Scalar> jacobian(d, u, q);
  if (jacobian.solvable()) {
    Model::dimension_jacobian(d, u, q, result.to_dimensions);
    Model::input_jacobian(d, u, q, result.to_inputs);
    result.to_dimensions = jacobian.solve(
        Matrix<Scalar, Model::unknown_count, Model::dimension_count>(-result.to_dimensions));
    result.to_inputs =
        jacobian.solve(Matrix<Scalar, Model::unknown_count, Model::input_count>(-result.to_inputs));
  }
  return jacobian.status();
}

/// Rates of motion: dq/dt and d2q/dt2.
template <typename Model, typename Scalar>
struct Motion {
  Vector<Scalar, Model::unknown_count> velocity;
  Vector<Scalar, Model::unknown_count> acceleration;
};

/// Solves J dq/dt = velocity_rhs and J d2q/dt2 = acceleration_rhs for the first and second rates of
/// the inputs. The result is set where the status is ok or near_singular.
template <typename Model, typename Scalar>
[[nodiscard]] Status motion(const typename Model::template Dimensions<Scalar>& d,
                            const typename Model::template Inputs<Scalar>& u,
                            const typename Model::template Configuration<Scalar>& q,
                            const Vector<Scalar, Model::input_count>& u_rate,
                            const Vector<Scalar, Model::input_count>& u_second_rate,
                            Motion<Model, Scalar>& result) {
  const FactoredJacobian<Model, Scalar> jacobian(d, u, q);
  if (jacobian.solvable()) {
    Vector<Scalar, Model::equation_count> rhs;
    Model::velocity_rhs(d, u, q, u_rate, rhs);
    result.velocity = jacobian.solve(rhs);
    Model::acceleration_rhs(d, u, q, result.velocity, u_rate, u_second_rate, rhs);
    result.acceleration = jacobian.solve(rhs);
  }
  return jacobian.status();
}

/// Newton's iteration from a guess to the loop closure, until the step is at rounding level. An
/// angle moves by at most half a radian a step. On `ok` and `near_singular` the configuration is
/// assembled; otherwise it is the last iterate. Newton may settle on any branch.
template <typename Model, typename Scalar>
[[nodiscard]] Status refine(const typename Model::template Dimensions<Scalar>& d,
                            const typename Model::template Inputs<Scalar>& u,
                            typename Model::template Configuration<Scalar>& q,
                            int max_iterations = 50) {
  constexpr int size = Model::unknown_count;
  const Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  Scalar previous = std::numeric_limits<Scalar>::infinity();
  for (int iteration = 0; iteration < max_iterations; ++iteration) {
    const FactoredJacobian<Model, Scalar> jacobian(d, u, q);
    if (!jacobian.solvable()) {
      return jacobian.status();
    }
    Vector<Scalar, Model::equation_count> residual;
    Model::residual(d, u, q, residual);
    Vector<Scalar, size> step = jacobian.solve(Vector<Scalar, size>(-residual));
    Scalar largest_turn(0);
    for (int index = 0; index < size; ++index) {
      if (Model::unknowns[static_cast<std::size_t>(index)].is_angle) {
        using std::abs;
        using std::max;
        largest_turn = max(largest_turn, abs(step(index)));
      }
    }
    const Scalar longest = step.cwiseAbs().maxCoeff();
    if (largest_turn > Scalar(0.5)) {
      step *= Scalar(0.5) / largest_turn;
    }
    advance(q, step);
    // Close to the solution the steps shrink quadratically until rounding stops them.
    const bool small = largest_turn < Scalar(1e3) * epsilon / jacobian.reciprocal_condition();
    if (longest == Scalar(0) || (small && !(longest < previous / Scalar(2)))) {
      return jacobian.status();
    }
    previous = longest;
  }
  return Status::no_convergence;
}

}  // namespace assur
