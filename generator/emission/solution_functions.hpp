// Turns the structured Jacobian into the functions that solve for rates and sensitivities.
#pragma once

#include <vector>

#include "emission/model_functions.hpp"
#include "solution/structured_jacobian.hpp"

namespace assur::generator {

/// A function with the quantities that it alone names.
struct NamingFunction {
  ModelFunction function;
  Vocabulary vocabulary;
};

[[nodiscard]] std::vector<NamingFunction> solution_functions(const StructuredJacobian& jacobian);

}  // namespace assur::generator
