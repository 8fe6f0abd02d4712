// Turns a rigid model's equations into the functions that solve them, and the names in these.
#pragma once

#include <vector>

#include "elimination/eliminate.hpp"
#include "emission/model/model_functions.hpp"
#include "emission/model/solution_functions.hpp"
#include "pivoting/structured_jacobian.hpp"

namespace assur::generator::emission::model {

struct RigidFunctions {
  std::vector<NamingFunction> solutions;  ///< of J x = rhs
  std::vector<ModelFunction> positions;   ///< they use the elimination's vocabulary
  std::vector<equations::NamedQuantity> known;
};

/// Reciprocals are added to the elimination's vocabulary.
[[nodiscard]] RigidFunctions rigid_functions(const equations::ClosureEquations& equations,
                                             const pivoting::StructuredJacobian& jacobian,
                                             elimination::Elimination& elimination);

}  // namespace assur::generator::emission::model
