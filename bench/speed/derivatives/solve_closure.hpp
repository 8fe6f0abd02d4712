// Derivatives of a configuration from those of its loop closures, by Eigen's LU.
#pragma once

#include <Eigen/LU>

#include "derivatives/derivative_errors.hpp"

namespace assur::speed {

/// LU with partial pivoting of J, for methods without an elimination of their own.
/// `second_derivative(velocity)` is d2f/dt2 with the second rates of the unknowns left out.
template <typename Scalar, typename SecondDerivative>
[[nodiscard]] DerivativesAnswer<Scalar> solved(const ClosureAnswer<Scalar>& f,
                                               const Vector<Scalar, 4>& u_rate,
                                               SecondDerivative second_derivative) {
  DerivativesAnswer<Scalar> answer;
  const Eigen::PartialPivLU<Matrix<Scalar, 4, 4>> factors(f.by_unknowns);
  Matrix<Scalar, 4, 12> rhs;
  rhs << f.by_dimensions, f.by_inputs;
  const Matrix<Scalar, 4, 12> S = factors.solve(-rhs);
  answer.sensitivities.to_dimensions = S.template leftCols<8>();
  answer.sensitivities.to_inputs = S.template rightCols<4>();
  answer.motion.velocity = answer.sensitivities.to_inputs * u_rate;
  answer.motion.acceleration = factors.solve(-second_derivative(answer.motion.velocity));
  return answer;
}

/// Velocity and acceleration only; `first_derivative` is df/dt with the unknowns held.
template <typename Scalar, typename SecondDerivative>
[[nodiscard]] MotionAnswer<Scalar> solved_motion(const Matrix<Scalar, 4, 4>& J,
                                                 const Vector<Scalar, 4>& first_derivative,
                                                 SecondDerivative second_derivative) {
  MotionAnswer<Scalar> answer;
  const Eigen::PartialPivLU<Matrix<Scalar, 4, 4>> factors(J);
  answer.motion.velocity = factors.solve(-first_derivative);
  answer.motion.acceleration = factors.solve(-second_derivative(answer.motion.velocity));
  return answer;
}

}  // namespace assur::speed
