// The assembled configuration of a geometry in 50 digits, and its derivatives.
#pragma once

#include <Eigen/LU>
#include <algorithm>

#include "problem.hpp"

namespace assur::stability {

/// Derivatives in 50 digits at one configuration.
template <typename Model>
struct Truth {
  Sensitivities<Model, Real> sensitivities;
  Motion<Model, Real> motion;
  /// The largest entry of each column of J. An unknown's rate times its weight is a rate of the
  /// closure, so that weighted angles and displacements have one unit.
  Vector<Real, Model::unknown_count> weights;
  double condition = 0;  ///< of J in the 1-norm, columns scaled by the weights
};

template <typename Model>
using RealJacobian = Matrix<Real, Model::equation_count, Model::unknown_count>;

/// Newton's iteration on the loop closure. False if it does not converge to 45 digits.
template <typename Model>
[[nodiscard]] bool assemble(Geometry<Model, Real>& g) {
  const Real tolerance = g.size * Real("1e-45");
  for (int iteration = 0; iteration < 60; ++iteration) {
    RealJacobian<Model> jacobian;
    Vector<Real, Model::equation_count> residual;
    Model::jacobian(g.d, g.u, g.q, jacobian);
    Model::residual(g.d, g.u, g.q, residual);
    const Vector<Real, Model::unknown_count> step =
        Eigen::FullPivLU<RealJacobian<Model>>(jacobian).solve(-residual);
    const Vector<Real, Model::unknown_count> moved =
        jacobian.cwiseAbs().colwise().maxCoeff().transpose().cwiseProduct(step.cwiseAbs());
    if (!(moved.maxCoeff() < Real(10) * g.size)) {
      return false;
    }
    advance(g.q, step);
    if (moved.maxCoeff() < tolerance) {
      return true;
    }
  }
  return false;
}

/// The derivatives at g.q, whether or not it is assembled.
template <typename Model>
[[nodiscard]] Truth<Model> derivatives(const Geometry<Model, Real>& g) {
  Truth<Model> truth;
  RealJacobian<Model> jacobian;
  Model::jacobian(g.d, g.u, g.q, jacobian);
  truth.weights = jacobian.cwiseAbs().colwise().maxCoeff();
  const RealJacobian<Model> scaled = jacobian * truth.weights.cwiseInverse().asDiagonal();
  const RealJacobian<Model> scaled_inverse =
      Eigen::FullPivLU<RealJacobian<Model>>(scaled).inverse();
  const auto one_norm = [](const RealJacobian<Model>& matrix) -> Real {
    return matrix.cwiseAbs().colwise().sum().maxCoeff();
  };
  truth.condition = static_cast<double>(Real(one_norm(scaled) * one_norm(scaled_inverse)));

  const RealJacobian<Model> inverse = truth.weights.cwiseInverse().asDiagonal() * scaled_inverse;
  Matrix<Real, Model::equation_count, Model::dimension_count> by_dimensions;
  Matrix<Real, Model::equation_count, Model::input_count> by_inputs;
  Model::dimension_jacobian(g.d, g.u, g.q, by_dimensions);
  Model::input_jacobian(g.d, g.u, g.q, by_inputs);
  truth.sensitivities.to_dimensions = -inverse * by_dimensions;
  truth.sensitivities.to_inputs = -inverse * by_inputs;
  Vector<Real, Model::equation_count> rhs;
  Model::velocity_rhs(g.d, g.u, g.q, g.u_rate, rhs);
  truth.motion.velocity = inverse * rhs;
  Model::acceleration_rhs(g.d, g.u, g.q, truth.motion.velocity, g.u_rate, g.u_second_rate, rhs);
  truth.motion.acceleration = inverse * rhs;
  return truth;
}

/// The acceleration for a given velocity, right or not.
template <typename Model>
struct AccelerationOf {
  Vector<Real, Model::unknown_count> acceleration;
  /// The centripetal and Coriolis terms of the right-hand side R relative to R:  |dR/dv| |v| / |R|,
  /// at least one.
  double cancellation = 1;
};

template <typename Model>
[[nodiscard]] AccelerationOf<Model> acceleration_of(
    const Geometry<Model, Real>& g, const Vector<Real, Model::unknown_count>& velocity) {
  const auto right_hand_side = [&](const Vector<Real, Model::unknown_count>& v) {
    Vector<Real, Model::equation_count> rhs;
    Model::acceleration_rhs(g.d, g.u, g.q, v, g.u_rate, g.u_second_rate, rhs);
    return rhs;
  };
  RealJacobian<Model> jacobian;
  Model::jacobian(g.d, g.u, g.q, jacobian);
  const Vector<Real, Model::equation_count> rhs = right_hand_side(velocity);
  // R is quadratic in the velocity, so a central difference is its derivative exactly.
  Real terms(0);
  for (int column = 0; column < Model::unknown_count; ++column) {
    Vector<Real, Model::unknown_count> step = Vector<Real, Model::unknown_count>::Zero();
    step(column) = velocity(column);
    const Vector<Real, Model::equation_count> change =
        right_hand_side(velocity + step) - right_hand_side(velocity - step);
    terms += change.cwiseAbs().maxCoeff() / Real(2);
  }
  AccelerationOf<Model> result;
  result.acceleration = Eigen::FullPivLU<RealJacobian<Model>>(jacobian).solve(rhs);
  result.cancellation = std::max(1.0, static_cast<double>(Real(terms / rhs.cwiseAbs().maxCoeff())));
  return result;
}

}  // namespace assur::stability
