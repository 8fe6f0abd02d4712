// The functions that solve a rigid model's equations, with the quantities that they name.
#pragma once

#include <vector>

#include "elimination/eliminate.hpp"
#include "emission/model/model_functions.hpp"
#include "emission/model/solution_functions.hpp"
#include "pivoting/structured_jacobian.hpp"

namespace assur::generator::emission::model {

struct RigidFunctions {
  std::vector<NamingFunction> solutions;  ///< of J x = rhs
  std::vector<ModelFunction> positions;   ///< with quantities of the elimination's vocabulary
  std::vector<equations::NamedQuantity> known;
};

/// Adds reciprocals to the elimination's vocabulary.
[[nodiscard]] RigidFunctions rigid_functions(const equations::ClosureEquations& equations,
                                             const pivoting::StructuredJacobian& jacobian,
                                             elimination::Elimination& elimination);

}  // namespace assur::generator::emission::model
