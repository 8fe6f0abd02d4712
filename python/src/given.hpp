// Conversion of parameter values given by a caller, in a mapping and as keywords, to numbers and
// arrays.
#pragma once

#include <pybind11/numpy.h>

#include <assur/mechanism/mechanism.hpp>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "errors.hpp"

namespace assur::python {

/// The name of a value's type.
[[nodiscard]] std::string type_of(const py::handle& value);
/// A Python string as UTF-8. Throws ShapeError for a value that is no string or has no UTF-8 form.
[[nodiscard]] std::string utf8_of(const py::handle& value, const std::string& what);
/// A whole number, zero or more. Throws ShapeError for any other value.
[[nodiscard]] std::uint64_t whole_number(const py::handle& value, const std::string& what);
/// The same as an int.
[[nodiscard]] int place_number(const py::handle& value, const std::string& what);

/// True or False. Throws ShapeError for any other value.
[[nodiscard]] bool truth(const py::handle& value, const std::string& what);

/// A positional argument: its name ends in a space, unlike that of any parameter, so that no
/// keyword can name it.
using ByPlace = py::arg;

/// Values by name; a keyword overrides the same name in the mapping.
using Given = std::vector<std::pair<std::string, py::object>>;
[[nodiscard]] Given given(const py::object& mapping, const py::kwargs& keywords);

/// Settings `NAME=EXPR` for reading a scene, from numbers and texts of expressions.
[[nodiscard]] std::vector<std::string> settings_of(const Given& given);

/// A number for each of some parameters. Throws UnknownName, and ShapeError for a value that is not
/// a number.
[[nodiscard]] std::vector<std::pair<std::string, double>> numbers_of(
    const mechanism::Mechanism& mechanism, const Given& given);

/// Whether some parameter has an array, or another sequence of values, rather than a number.
[[nodiscard]] bool has_arrays(const Given& given);

/// Parameters, and `count` values for each of them. Rows are read without the interpreter's lock,
/// from plain memory that the arrays keep alive.
struct Columns {
  struct Column {
    mechanism::ParameterIndex parameter;
    const char* first;
    py::ssize_t stride;  ///< in bytes; zero if all rows share one number
  };

  std::vector<Column> columns;
  std::vector<py::array_t<double>> owners;
  py::ssize_t count = 0;

  [[nodiscard]] std::vector<std::pair<mechanism::ParameterIndex, double>> row(py::ssize_t at) const;
};

/// Arrays of one length, not copied if they hold doubles; a single number applies to all rows.
/// Throws UnknownName, and ShapeError for other shapes, or if no array is given.
[[nodiscard]] Columns columns_of(const mechanism::Mechanism& mechanism, const Given& given);

}  // namespace assur::python
