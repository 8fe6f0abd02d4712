#include "given.hpp"

#include <algorithm>
#include <assur/text/counts.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

namespace assur::python {

namespace {

std::string shape_of(const py::handle& array) {
  return py::cast<std::string>(py::str(array.attr("shape")));
}

/// The text of a whole number; for any other value the name of its type.
std::string shown(const py::handle& value) {
  return PyLong_Check(value.ptr()) != 0 ? py::cast<std::string>(py::str(value)) : type_of(value);
}

double number_of(const std::string& name, const py::handle& value) {
  if (PyFloat_Check(value.ptr()) != 0) {
    return PyFloat_AS_DOUBLE(value.ptr());
  }
  if (py::isinstance<py::array>(value) && py::reinterpret_borrow<py::array>(value).ndim() > 0) {
    throw ShapeError(name + ": expected a number, not an array of shape " + shape_of(value) +
                     "; Plan.solve_batch and Plan.sweep take arrays");
  }
  const double number = PyFloat_AsDouble(value.ptr());
  if (PyErr_Occurred() != nullptr) {
    const bool is_too_large = PyErr_ExceptionMatches(PyExc_OverflowError) != 0;
    PyErr_Clear();
    if (is_too_large) {
      throw ShapeError(name + ": the number is too large for a double");
    }
    throw ShapeError(
        name + ": expected a number, not " + type_of(value) +
        (PyUnicode_Check(value.ptr()) ? "; read_scene and parse_scene take expressions" : ""));
  }
  return number;
}

mechanism::ParameterIndex parameter_named(const mechanism::Mechanism& mechanism,
                                          const std::string& name) {
  const auto parameter = text::index_of(mechanism.parameters(), name);
  if (!parameter.exists()) {
    throw UnknownName("parameter", name, text::names_of(mechanism.parameters()));
  }
  return parameter;
}

/// A number, or a list of numbers.
py::array_t<double> array_of(const std::string& name, const py::handle& value) {
  const py::array given = py::array::ensure(value);
  const bool holds_numbers =
      given && std::string_view("biufO").find(given.dtype().kind()) != std::string_view::npos;
  auto array = holds_numbers ? py::array_t<double>::ensure(given) : py::array_t<double>();
  if (!holds_numbers || !array) {
    PyErr_Clear();
    throw ShapeError(
        name + ": expected an array of numbers, not " +
        (given ? "one of dtype " + py::cast<std::string>(py::str(given.dtype())) : type_of(value)));
  }
  if (array.ndim() > 1) {
    throw ShapeError(name + ": expected one dimension, not an array of shape " + shape_of(array) +
                     "; give each parameter an array of its own");
  }
  return array;
}

}  // namespace

std::string type_of(const py::handle& value) {
  return py::cast<std::string>(py::type::handle_of(value).attr("__name__"));
}

std::string utf8_of(const py::handle& value, const std::string& what) {
  if (PyUnicode_Check(value.ptr()) == 0) {
    throw ShapeError(what + " must be a text, not " + type_of(value));
  }
  Py_ssize_t size = 0;
  const char* const text = PyUnicode_AsUTF8AndSize(value.ptr(), &size);
  if (text == nullptr) {
    PyErr_Clear();
    throw ShapeError(what + " holds a surrogate, which is not a character");
  }
  return {text, static_cast<std::size_t>(size)};
}

std::uint64_t whole_number(const py::handle& value, const std::string& what) {
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  const unsigned long long whole = number ? PyLong_AsUnsignedLongLong(number.ptr()) : 0;
  if (PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    throw ShapeError(what + ": expected a whole number from 0, not " + shown(value));
  }
  return whole;
}

int place_number(const py::handle& value, const std::string& what) {
  const std::uint64_t number = whole_number(value, what);
  if (number > static_cast<std::uint64_t>(std::numeric_limits<int>::max())) {
    throw ShapeError(what + ": expected a whole number from 1 to " +
                     std::to_string(std::numeric_limits<int>::max()));
  }
  return static_cast<int>(number);
}

bool truth(const py::handle& value, const std::string& what) {
  if (PyBool_Check(value.ptr()) == 0) {
    throw ShapeError(what + ": expected True or False, not " + type_of(value));
  }
  return value.ptr() == Py_True;
}

Given given(const py::object& mapping, const py::kwargs& keywords) {
  Given all;
  const auto add = [&all](const py::handle& key, const py::handle& value) {
    const std::string name = utf8_of(key, "values: a parameter's name");
    const auto at =
        std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.first == name; });
    if (at == all.end()) {
      all.emplace_back(name, py::reinterpret_borrow<py::object>(value));
    } else {
      at->second = py::reinterpret_borrow<py::object>(value);
    }
  };
  if (!mapping.is_none()) {
    if (!py::hasattr(mapping, "items")) {
      throw ShapeError("values: expected a mapping from parameters' names, not " +
                       type_of(mapping) + "; give {'phi': ...}, or the keyword phi=...");
    }
    for (const auto& [key, value] : py::dict(mapping)) {
      add(key, value);
    }
  }
  for (const auto& [key, value] : keywords) {
    add(key, value);
  }
  return all;
}

std::vector<std::string> settings_of(const Given& given) {
  std::vector<std::string> settings;
  for (const auto& [name, value] : given) {
    if (PyUnicode_Check(value.ptr()) != 0) {
      settings.push_back(name + "=" + utf8_of(value, name));
      continue;
    }
    const double number = number_of(name, value);
    if (!std::isfinite(number)) {
      throw ShapeError(name + ": expected a finite number");
    }
    settings.push_back(name + "=" + py::cast<std::string>(py::repr(py::float_(number))));
  }
  return settings;
}

std::vector<std::pair<std::string, double>> numbers_of(const mechanism::Mechanism& mechanism,
                                                       const Given& given) {
  std::vector<std::pair<std::string, double>> numbers;
  numbers.reserve(given.size());
  for (const auto& [name, value] : given) {
    parameter_named(mechanism, name);
    numbers.emplace_back(name, number_of(name, value));
  }
  return numbers;
}

bool has_arrays(const Given& given) {
  return std::ranges::any_of(given, [](const auto& one) {
    const py::object& value = one.second;
    return py::isinstance<py::array>(value)
               ? py::reinterpret_borrow<py::array>(value).ndim() > 0
               : PySequence_Check(value.ptr()) != 0 && PyUnicode_Check(value.ptr()) == 0;
  });
}

Columns columns_of(const mechanism::Mechanism& mechanism, const Given& given) {
  Columns columns;
  std::string first;
  for (const auto& [name, value] : given) {
    const mechanism::ParameterIndex parameter = parameter_named(mechanism, name);
    const py::array_t<double>& array = columns.owners.emplace_back(array_of(name, value));
    columns.columns.push_back({parameter, reinterpret_cast<const char*>(array.data()),
                               array.ndim() == 0 ? 0 : array.strides(0)});
    if (array.ndim() == 0) {
      continue;
    }
    if (!first.empty() && array.size() != columns.count) {
      throw ShapeError(name + ": expected " +
                       text::with_noun(static_cast<std::size_t>(columns.count), "value") + ", as " +
                       first + " has, not " + std::to_string(array.size()));
    }
    first = name;
    columns.count = array.size();
  }
  if (first.empty()) {
    throw ShapeError("values: no parameter has an array of values; Plan.solve takes numbers");
  }
  return columns;
}

std::vector<std::pair<mechanism::ParameterIndex, double>> Columns::row(py::ssize_t at) const {
  std::vector<std::pair<mechanism::ParameterIndex, double>> row;
  row.reserve(columns.size());
  for (const Column& column : columns) {
    double value = 0;
    std::memcpy(&value, column.first + at * column.stride, sizeof value);  // it may be unaligned
    row.emplace_back(column.parameter, value);
  }
  return row;
}

}  // namespace assur::python
