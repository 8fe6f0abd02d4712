// Tuples of names for Python.
#pragma once

#include <pybind11/stl.h>

#include <string>
#include <vector>

namespace assur::python {

[[nodiscard]] inline pybind11::tuple tuple_of(const std::vector<std::string>& names) {
  return {pybind11::cast(names)};
}

}  // namespace assur::python
