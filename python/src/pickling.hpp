// Pickling of results: numbers are stored as the bytes of arrays.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstring>
#include <memory>
#include <vector>

#include "plan.hpp"
#include "rows.hpp"

namespace assur::python {

template <typename Number>
[[nodiscard]] py::bytes bytes_of(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

template <typename Number>
[[nodiscard]] std::vector<Number> numbers_in(const py::handle& bytes) {
  char* memory = nullptr;
  py::ssize_t size = 0;
  if (PyBytes_AsStringAndSize(bytes.ptr(), &memory, &size) != 0) {
    throw py::error_already_set();
  }
  std::vector<Number> numbers(static_cast<std::size_t>(size) / sizeof(Number));
  if (size > 0) {
    std::memcpy(numbers.data(), memory, static_cast<std::size_t>(size));
  }
  return numbers;
}

[[nodiscard]] inline py::tuple rows_state(const RowsView& view) {
  return py::make_tuple(bytes_of(view.rows->numbers()), bytes_of(view.rows->regularities()),
                        view.rows->reasons());
}

[[nodiscard]] inline std::shared_ptr<const Rows> rows_in(const PlannedScene& planned,
                                                         const py::handle& state) {
  const auto parts = py::cast<py::tuple>(state);
  return std::make_shared<Rows>(planned.plan, planned.layout, numbers_in<double>(parts[0]),
                                numbers_in<unsigned char>(parts[1]),
                                parts[2].cast<std::vector<std::string>>());
}

}  // namespace assur::python
