// The extension module of the Python package.
#include <pybind11/numpy.h>

#include <assur/mechanism/scene_file.hpp>
#include <assur/version.hpp>

#include "bindings.hpp"
#include "errors.hpp"

namespace assur::python {
namespace {

PYBIND11_MODULE(_assur, module) {
  // Docstrings begin with signatures that inspect.signature reads.
  py::options options;
  options.disable_function_signatures();
  module.doc() = "Planar linkages in closed form; see the package assur.";
  module.attr("__version__") = version;
  // The first use of NumPy imports it. Two threads that import it at once could deadlock.
  (void)py::dtype::of<double>();
  translate_errors();
  bind_scene(module);
  bind_parts(module);
  bind_solution(module);
  bind_plan(module);
  bind_sample(module);
  refuse_plainly(module);
}

}  // namespace
}  // namespace assur::python
