// Turns a model's equations and derivatives into the list of functions that its header holds.
#pragma once

#include <string>
#include <vector>

#include "derivatives/differentiate.hpp"
#include "elimination/eliminate.hpp"
#include "subexpressions/program.hpp"

namespace assur::generator {

/// A parameter of an emitted function; it stays unnamed in C++ where the body does not use it.
struct Parameter {
  std::string type;
  std::string name;
};

/// One function to emit: results are assigned to the `outputs`, which are cleared first where most
/// of their entries are zero.
struct ModelFunction {
  std::string name;
  std::vector<std::string> doc;
  std::vector<Parameter> inputs;
  std::vector<Parameter> outputs;
  std::vector<Result> results;
};

/// Residual, Jacobians and right-hand sides.
[[nodiscard]] std::vector<ModelFunction> residual_functions(const ImplicitEquations& equations,
                                                            const ResidualDerivatives& derivatives);
/// The same, and the poses of the links with their derivatives.
[[nodiscard]] std::vector<ModelFunction> model_functions(const ClosureEquations& equations,
                                                         const Derivatives& derivatives);

/// The functions of a rigid model's position analysis; they use the elimination's vocabulary, to
/// which reciprocals are added.
[[nodiscard]] std::vector<ModelFunction> position_functions(const ClosureEquations& equations,
                                                            Elimination& elimination);

/// Ranks the symbols of a model: unknowns, dimensions, inputs, rates, then named quantities.
[[nodiscard]] SymbolOrder symbol_order(const ImplicitEquations& equations,
                                       const Vocabulary& vocabulary);

}  // namespace assur::generator
