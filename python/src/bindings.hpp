// Functions that define the classes and functions of the extension module, by subject.
#pragma once

#include <pybind11/pybind11.h>

namespace assur::python {

namespace py = pybind11;

// Each defines classes that later ones use; `module.cpp` calls them in order.
void bind_scene(py::module_& module);
/// Links, slides, outputs, their mappings, and the rows that hold them.
void bind_parts(py::module_& module);
void bind_solution(py::module_& module);
void bind_plan(py::module_& module);
void bind_sample(py::module_& module);
/// Makes every bound function refuse other arguments with one line.
void refuse_plainly(const py::module_& module);

}  // namespace assur::python
