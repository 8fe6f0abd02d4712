// Conversion of results to tables of pandas, by the Python part of the package.
#pragma once

#include <pybind11/pybind11.h>

namespace assur::python {

inline constexpr const char* frame_doc =
    "to_frame(self)\n--\n\n"
    "Returns a DataFrame of pandas, with a row for each row and the columns of the command's "
    "CSV.\n\n"
    "Raises ImportError where pandas is not installed.";

/// A DataFrame of pandas.
[[nodiscard]] inline pybind11::object frame_of(const pybind11::object& self) {
  return pybind11::module_::import("assur.tables").attr("frame_of")(self);
}

}  // namespace assur::python
