// NumPy arrays as views of memory that an object owns and that they keep alive.
#pragma once

#include <pybind11/numpy.h>

#include <vector>

#include "rows.hpp"

namespace assur::python {

namespace py = pybind11;

/// A read-only view. `strides` are in bytes; the owner must no longer change.
[[nodiscard]] py::array view(const py::dtype& type, std::vector<py::ssize_t> shape,
                             std::vector<py::ssize_t> strides, const void* memory,
                             const py::object& owner);

/// A view of a whole vector of numbers.
template <typename Number>
[[nodiscard]] py::array view_of(const std::vector<Number>& numbers, const py::object& owner) {
  return view(py::dtype::of<Number>(), {static_cast<py::ssize_t>(numbers.size())},
              {static_cast<py::ssize_t>(sizeof(Number))}, numbers.data(), owner);
}

/// The numbers at an offset of one row, a float if the shape is empty; or those of all rows, as an
/// array with one entry per row.
[[nodiscard]] py::object numbers_at(const RowsView& of, std::size_t place,
                                    const std::vector<std::ptrdiff_t>& shape,
                                    const py::object& owner);

/// Whether one row is regular; for all rows, an array.
[[nodiscard]] py::object regular_at(const RowsView& of, const py::object& owner);

}  // namespace assur::python
