#include "arrays.hpp"

#include <utility>

namespace assur::python {

py::array view(const py::dtype& type, std::vector<py::ssize_t> shape,
               std::vector<py::ssize_t> strides, const void* memory, const py::object& owner) {
  static const double nothing = 0;  // address for an empty array; with none, NumPy would allocate
  py::array array(type, std::move(shape), std::move(strides), memory == nullptr ? &nothing : memory,
                  owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

py::object numbers_at(const RowsView& of, std::size_t place,
                      const std::vector<std::ptrdiff_t>& shape, const py::object& owner) {
  if (of.is_one() && shape.empty()) {
    return py::float_(of.first()[place]);
  }
  const Layout& layout = of.rows->layout();
  std::vector<py::ssize_t> extents;
  if (!of.is_one()) {
    extents.push_back(static_cast<py::ssize_t>(of.rows->count()));
  }
  for (const std::ptrdiff_t extent : shape) {
    extents.push_back(extent == parameters ? layout.parameter_count : extent);
  }
  std::vector<py::ssize_t> strides(extents.size());
  auto stride = static_cast<py::ssize_t>(sizeof(double));
  for (std::size_t axis = extents.size(); axis-- > 0;) {
    const bool is_row = axis == 0 && !of.is_one();
    strides[axis] = is_row ? static_cast<py::ssize_t>(layout.width() * sizeof(double)) : stride;
    stride *= extents[axis];
  }
  const double* const memory = of.rows->count() > 0 ? of.first() + place : nullptr;
  return view(py::dtype::of<double>(), std::move(extents), std::move(strides), memory, owner);
}

py::object regular_at(const RowsView& of, const py::object& owner) {
  if (of.is_one()) {
    return py::bool_(of.rows->regular()[of.row] != 0);
  }
  return view(py::dtype::of<bool>(), {static_cast<py::ssize_t>(of.rows->count())}, {1},
              of.rows->regular(), owner);
}

}  // namespace assur::python
