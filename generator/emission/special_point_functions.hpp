// Turns a model's special points into the functions by which the runtime solves with them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "derivatives/special_points.hpp"
#include "emission/model_functions.hpp"

namespace assur::generator {

/// Functions that read points and normals beside the model's variables.
struct SpecialPointFunctions {
  std::vector<ModelFunction> functions;
  /// The symbols of points and normals, and the entry of a parameter that each one is: `S(0, 1)`.
  std::vector<std::pair<GiNaC::symbol, std::string>> symbols;
};

/// The functions of a model whose special points are defined.
[[nodiscard]] SpecialPointFunctions special_point_functions(const ClosureEquations& equations,
                                                            const SpecialPoints& special);

/// What the special points are, a line a point, for reading; or why there are none.
[[nodiscard]] std::vector<std::string> special_point_lines(const ClosureEquations& equations,
                                                           const SpecialPoints& special);

}  // namespace assur::generator
