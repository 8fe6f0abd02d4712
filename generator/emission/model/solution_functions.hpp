// Turns the structured Jacobian into the functions that solve for rates and sensitivities.
#pragma once

#include <vector>

#include "emission/model/model_functions.hpp"
#include "pivoting/structured_jacobian.hpp"

namespace assur::generator::emission::model {

/// A function with its own vocabulary: the common quantities, and those that it alone names.
struct NamingFunction {
  ModelFunction function;
  equations::Vocabulary vocabulary;
};

[[nodiscard]] std::vector<NamingFunction> solution_functions(
    const pivoting::StructuredJacobian& jacobian);

}  // namespace assur::generator::emission::model
