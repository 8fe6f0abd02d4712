#include "errors.hpp"

#include <pybind11/stl.h>

#include <assur/text/suggestion.hpp>
#include <exception>
#include <utility>

namespace assur::python {

namespace {

/// A name from a file may contain invalid UTF-8.
py::object line_of(const std::exception& error) {
  const std::string line = error.what();
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(line.data(), static_cast<Py_ssize_t>(line.size()), "backslashreplace"));
}

py::object exception_of(const char* type, const std::exception& error) {
  return py::module_::import("assur.errors").attr(type)(line_of(error));
}

void raise(const py::object& exception) {
  PyErr_SetObject(py::type::handle_of(exception).ptr(), exception.ptr());
}

}  // namespace

UnknownName::UnknownName(const std::string& what, const std::string& name,
                         const std::vector<std::string>& known)
    : InputError(mechanism::MechanismError("", "no " + what + " named '" + name + "'" +
                                                   text::suggestion_or_choice(name, known))
                     .what()) {}

mechanism::OverConstrained in_file(const std::string& file,
                                   const mechanism::OverConstrained& error) {
  mechanism::OverConstrained result(file, error.what(), error.surplus, error.joints, error.lack);
  result.gap = error.gap;
  return result;
}

void translate_errors() {
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const mechanism::OverConstrained& error) {
      const py::object exception = exception_of("OverConstrained", error);
      exception.attr("surplus") = error.surplus;
      exception.attr("joints") = py::tuple(py::cast(error.joints));
      raise(exception);
    } catch (const UnknownName& error) {
      raise(exception_of("UnknownName", error));
    } catch (const ShapeError& error) {
      raise(exception_of("ShapeError", error));
    } catch (const NotWanted& error) {
      raise(exception_of("NotWanted", error));
    } catch (const text::InputError& error) {
      raise(exception_of("SceneError", error));
    }
  });
}

}  // namespace assur::python
