// Functions by which the runtime solves with a model's special points.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "emission/model/model_functions.hpp"
#include "special_points/special_points.hpp"

namespace assur::generator::emission::model {

/// Functions that read points and normals besides the model's variables.
struct SpecialPointFunctions {
  std::vector<ModelFunction> functions;
  /// The symbols of points and normals, and the entry of a parameter that holds each: `S(0, 1)`.
  std::vector<std::pair<GiNaC::symbol, program::Place>> symbols;
};

/// The functions of a model whose special points are defined.
[[nodiscard]] SpecialPointFunctions special_point_functions(
    const equations::ClosureEquations& equations, const special_points::SpecialPoints& special);

/// A description of the special points, one line each, or of the reason why there are none.
[[nodiscard]] std::vector<std::string> special_point_lines(
    const equations::ClosureEquations& equations, const special_points::SpecialPoints& special);

}  // namespace assur::generator::emission::model
