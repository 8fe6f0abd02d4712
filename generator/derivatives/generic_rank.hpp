// Turns a Jacobian into its generic rank, whether or not its equations have a solution.
#pragma once

#include "derivatives/differentiate.hpp"

namespace assur::generator::derivatives {

/// The rank at random points, of which few may lie where it is less: exact without roots, and by
/// decimals of 60 digits with them. The points need not fulfil the equations. Roots are real there,
/// unless no such point is found.
[[nodiscard]] unsigned generic_rank(const equations::ImplicitEquations& equations,
                                    const ExpressionMatrix& jacobian);

}  // namespace assur::generator::derivatives
