// Turns a geometry in 50 digits into its assembled configuration and the derivatives there.
#pragma once

#include "problem.hpp"

namespace assur::stability {

/// Derivatives in 50 digits at one configuration.
template <typename Model>
struct Truth {
  Sensitivities<Model, Real> sensitivities;
  Motion<Model, Real> motion;
  /// The largest entry of each column of J: an unknown's rate times it is a rate of the closure, so
  /// weighted unknowns, angles and displacements alike, have one unit.
  Vector<Real, Model::unknown_count> weights;
  double condition = 0;  ///< of J in the 1-norm, columns scaled by the weights
  /// That of the acceleration, which is computed from the velocity: condition (1 + how much larger
  /// a relative error of the velocity arrives in the acceleration).
  double acceleration_condition = 0;
};

template <typename Model>
using RealJacobian = Matrix<Real, Model::equation_count, Model::unknown_count>;

/// Newton's iteration on the loop closure. False if it does not settle at 45 digits.
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

/// |dR/dv'| |v| / |a| for the right-hand side R of J a = R, all weighted, where dR/dv' stands for
/// the inverse of J times the derivative of R by the velocity; infinity norm. R is quadratic in the
/// velocity, so a central difference is its derivative exactly.
template <typename Model>
[[nodiscard]] Real magnification(const Geometry<Model, Real>& g, const Truth<Model>& truth,
                                 const RealJacobian<Model>& scaled_inverse) {
  RealJacobian<Model> by_velocity;
  for (int column = 0; column < Model::unknown_count; ++column) {
    Vector<Real, Model::unknown_count> ahead = truth.motion.velocity;
    Vector<Real, Model::unknown_count> behind = truth.motion.velocity;
    ahead(column) += Real(1) / truth.weights(column);
    behind(column) -= Real(1) / truth.weights(column);
    Vector<Real, Model::equation_count> rhs_ahead;
    Vector<Real, Model::equation_count> rhs_behind;
    Model::acceleration_rhs(g.d, g.u, g.q, ahead, g.u_rate, g.u_second_rate, rhs_ahead);
    Model::acceleration_rhs(g.d, g.u, g.q, behind, g.u_rate, g.u_second_rate, rhs_behind);
    by_velocity.col(column) = (rhs_ahead - rhs_behind) / Real(2);
  }
  const RealJacobian<Model> arriving = scaled_inverse * by_velocity;
  const Real norm = arriving.cwiseAbs().rowwise().sum().maxCoeff();
  const Real velocity = truth.weights.cwiseProduct(truth.motion.velocity).cwiseAbs().maxCoeff();
  const Real acceleration =
      truth.weights.cwiseProduct(truth.motion.acceleration).cwiseAbs().maxCoeff();
  return norm * velocity / acceleration;
}

/// The derivatives at g.q, whether it is assembled or not.
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
  truth.acceleration_condition =
      truth.condition * (1 + static_cast<double>(magnification(g, truth, scaled_inverse)));
  return truth;
}

}  // namespace assur::stability
