#include "emission/model/rigid_functions.hpp"

namespace assur::generator::emission::model {

RigidFunctions rigid_functions(const equations::ClosureEquations& equations,
                               const pivoting::StructuredJacobian& jacobian,
                               elimination::Elimination& elimination) {
  RigidFunctions result;
  result.solutions = solution_functions(jacobian);
  result.positions = position_functions(equations, elimination);
  std::vector<const equations::Vocabulary*> vocabularies = {&equations.vocabulary,
                                                            &elimination.vocabulary};
  for (const NamingFunction& function : result.solutions) {
    vocabularies.push_back(&function.vocabulary);
  }
  result.known = known_quantities(equations, vocabularies);
  return result;
}

}  // namespace assur::generator::emission::model
