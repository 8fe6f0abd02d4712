// Generic rank of a Jacobian, whether or not its equations have a solution.
#pragma once

#include "derivatives/differentiate.hpp"

namespace assur::generator::derivatives {

/// Returns the largest rank at four random points, which need not satisfy the equations. It is
/// exact if there are no roots; otherwise decimals of 60 digits are compared. All roots are real at
/// these points, unless no such point is found.
[[nodiscard]] unsigned generic_rank(const equations::ImplicitEquations& equations,
                                    const ExpressionMatrix& jacobian);

}  // namespace assur::generator::derivatives
