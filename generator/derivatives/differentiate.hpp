// Derivatives of loop-closure equations: Jacobian, sensitivities and time derivatives.
#pragma once

#include <vector>

#include "equations/closure.hpp"

namespace assur::generator::derivatives {

/// Row-major matrix of expressions in the names of the equations' vocabulary.
using ExpressionMatrix = std::vector<std::vector<GiNaC::ex>>;

/// Derivatives of f(q, d, u) = 0 with unknowns q, dimensions d and inputs u. With q' for dq/dt:
///   J q' = velocity_rhs,  J q'' = acceleration_rhs,  J q''' = jerk_rhs,
///   J dq/dd = -dimension_jacobian,  J dq/du = -input_jacobian,
/// and where the dimensions move as well, with d' and u' constant,
///   J q'' = curvature_rhs.
struct ResidualDerivatives {
  ExpressionMatrix jacobian;            ///< df/dq
  ExpressionMatrix dimension_jacobian;  ///< df/dd
  ExpressionMatrix input_jacobian;      ///< df/du
  std::vector<GiNaC::ex> velocity_rhs;
  std::vector<GiNaC::ex> acceleration_rhs;
  std::vector<GiNaC::ex> jerk_rhs;
  std::vector<GiNaC::ex> curvature_rhs;
};

/// Derivatives of a model: of its closures, and of the link poses p = (x, y, theta).
struct Derivatives : ResidualDerivatives {
  ExpressionMatrix pose_unknown_jacobian;    ///< dp/dq, three rows per link
  ExpressionMatrix pose_dimension_jacobian;  ///< dp/dd
  ExpressionMatrix pose_input_jacobian;      ///< dp/du
  ExpressionMatrix pose_velocity;            ///< dp/dt, one row per link
  ExpressionMatrix pose_acceleration;        ///< d2p/dt2, one row per link
  ExpressionMatrix pose_curvature;           ///< d2p/dt2 for constant q', d', u', one row per link
};

/// df/dq only.
[[nodiscard]] ExpressionMatrix closure_jacobian(const equations::ImplicitEquations& equations);
[[nodiscard]] ResidualDerivatives differentiate_residuals(
    const equations::ImplicitEquations& equations);

[[nodiscard]] Derivatives differentiate(const equations::ClosureEquations& equations);

}  // namespace assur::generator::derivatives
