// The methods that the stability laboratory compares.
#pragma once

#include <vector>

#include "half_angle.hpp"
#include "linear_methods.hpp"
#include "step_methods.hpp"

namespace assur::stability {

template <typename Model>
struct Method {
  const char* name;
  Answer<Model> (*answer)(const Geometry<Model, double>&);
};

/// In one order for every model. Special points come last, since not every model has them.
template <typename Model>
[[nodiscard]] std::vector<Method<Model>> methods() {
  std::vector<Method<Model>> list = {
      {"generated", generated<Model>},
      {"partial-pivot LU", partial_pivot_lu<Model>},
      {"full-pivot LU", full_pivot_lu<Model>},
      {"automatic differentiation", automatic_differentiation<Model>},
      {"complex step", complex_step<Model>},
      {"half-angle tangents", half_angle<Model>},
      {"Newton from a neighbour", newton<Model>},
      {"central differences", central_differences<Model>},
  };
  if constexpr (Model::has_special_points) {
    list.push_back({"special points", special_points<Model>});
  }
  return list;
}

}  // namespace assur::stability
