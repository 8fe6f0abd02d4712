// The functions of a model's header, from its equations and derivatives.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "derivatives/differentiate.hpp"
#include "elimination/eliminate.hpp"
#include "program/program.hpp"

namespace assur::generator::emission::model {

/// A parameter of an emitted function; it has no name in C++ if the body does not use it.
struct Parameter {
  std::string type;
  std::string name;
};

/// One function to emit; results are assigned to the `outputs`. A matrix or vector is cleared first
/// if any of its entries is zero.
struct ModelFunction {
  std::string name;
  std::vector<std::string> doc;
  std::vector<Parameter> inputs;
  std::vector<Parameter> outputs;
  std::vector<program::Result> results;
};

/// The quantities that the functions of one model name, each once, except rates, which some
/// functions compute and others take.
[[nodiscard]] std::vector<equations::NamedQuantity> known_quantities(
    const equations::ImplicitEquations& equations,
    const std::vector<const equations::Vocabulary*>& vocabularies);

/// Residual, Jacobians and right-hand sides.
[[nodiscard]] std::vector<ModelFunction> residual_functions(
    const equations::ImplicitEquations& equations,
    const derivatives::ResidualDerivatives& derivatives);
/// As above, with the poses of the links and their derivatives.
[[nodiscard]] std::vector<ModelFunction> model_functions(
    const equations::ClosureEquations& equations, const derivatives::Derivatives& derivatives);

/// Adds the frame of a link, at a place among `poses`; without `has_origin` its direction alone.
void add_frame(std::size_t place, const equations::LinkPose& pose, bool has_origin,
               std::vector<program::Result>& results);

/// The functions of a rigid model's position analysis. They use the elimination's vocabulary and
/// add reciprocals to it.
[[nodiscard]] std::vector<ModelFunction> position_functions(
    const equations::ClosureEquations& equations, elimination::Elimination& elimination);

}  // namespace assur::generator::emission::model
