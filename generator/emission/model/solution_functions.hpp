// Functions that solve for rates and sensitivities by the structured Jacobian.
#pragma once

#include <vector>

#include "emission/model/model_functions.hpp"
#include "pivoting/structured_jacobian.hpp"

namespace assur::generator::emission::model {

/// A function with its vocabulary: the common quantities, and its own.
struct NamingFunction {
  ModelFunction function;
  equations::Vocabulary vocabulary;
};

[[nodiscard]] std::vector<NamingFunction> solution_functions(
    const pivoting::StructuredJacobian& jacobian);

}  // namespace assur::generator::emission::model
