// Turns each subject of the package into its classes and functions in the module.
#pragma once

#include <pybind11/pybind11.h>

namespace assur::python {

namespace py = pybind11;

// Each defines classes that later ones name; `module.cpp` calls them in order.
void bind_scene(py::module_& module);
/// Links, slides, outputs, their mappings, and the rows that hold them.
void bind_parts(py::module_& module);
void bind_solution(py::module_& module);
void bind_plan(py::module_& module);
void bind_sample(py::module_& module);
/// Has every function that was bound refuse other arguments in one line.
void refuse_plainly(const py::module_& module);

}  // namespace assur::python
