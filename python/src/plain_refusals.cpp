// One-line errors for calls with arguments that no function accepts, in place of pybind11's list of
// C++ types.
#include <string>

#include "bindings.hpp"
#include "given.hpp"

namespace assur::python {

namespace {

/// The signature with which the docstring of a function or a class begins.
std::string signature_of(const py::handle& function, const std::string& name) {
  const py::object signature = py::getattr(function, "__text_signature__", py::none());
  return name + (signature.is_none() ? "()" : py::cast<std::string>(py::str(signature)));
}

std::string types_of(const py::args& args, const py::kwargs& keywords, bool is_method) {
  std::string types;
  const auto add = [&types](const std::string& type) {
    types += (types.empty() ? "" : ", ") + type;
  };
  for (std::size_t place = is_method ? 1 : 0; place < args.size(); ++place) {
    add(type_of(args[place]));
  }
  for (const auto& [name, value] : keywords) {
    add(py::cast<std::string>(py::str(name)) + "=" + type_of(value));
  }
  return types;
}

/// Adds a last overload that accepts any arguments and refuses them.
void refuse_other_arguments(const py::object& scope, const std::string& owner,
                            const std::string& name, const py::object& function, bool is_method) {
  const std::string shown = name == "__init__" ? owner : owner + (owner.empty() ? "" : ".") + name;
  const std::string expected =
      name == "__init__" ? signature_of(scope, owner) : signature_of(function, name);
  const auto refuse = [shown, expected, is_method](const py::args& args,
                                                   const py::kwargs& keywords) -> py::object {
    throw py::type_error(shown + ": expected " + expected + ", not the arguments (" +
                         types_of(args, keywords, is_method) + ")");
  };
  if (is_method) {
    const py::cpp_function added(refuse, py::name(name.c_str()), py::is_method(scope),
                                 py::sibling(function));
    scope.attr(name.c_str()) = added;
  } else {
    const py::cpp_function added(refuse, py::name(name.c_str()), py::scope(scope),
                                 py::sibling(function));
    scope.attr(name.c_str()) = added;
  }
}

}  // namespace

void refuse_plainly(const py::module_& module) {
  for (const auto& [key, value] : py::dict(module.attr("__dict__"))) {
    const auto name = py::cast<std::string>(key);
    if (PyCFunction_Check(value.ptr()) != 0) {
      refuse_other_arguments(module, "", name, py::reinterpret_borrow<py::object>(value), false);
    } else if (PyType_Check(value.ptr()) != 0) {
      const auto type = py::reinterpret_borrow<py::object>(value);
      for (const auto& [member, method] : py::dict(type.attr("__dict__"))) {
        if (PyInstanceMethod_Check(method.ptr()) != 0) {
          refuse_other_arguments(type, name, py::cast<std::string>(member),
                                 py::getattr(type, member), true);
        }
      }
    }
  }
}

}  // namespace assur::python
