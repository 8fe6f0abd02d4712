// Exceptions of the Python package, and their translation from errors of the library.
#pragma once

#include <pybind11/pybind11.h>

#include <assur/mechanism/error.hpp>
#include <string>
#include <vector>

namespace assur::python {

namespace py = pybind11;

/// A parameter, link, joint or output that does not exist: `no output 'Q' (did you mean 'P'?)`.
class UnknownName : public text::InputError {
 public:
  UnknownName(const std::string& what, const std::string& name,
              const std::vector<std::string>& known);
};

/// A value that is not a number, or an array of the wrong shape.
class ShapeError : public text::InputError {
 public:
  using InputError::InputError;
};

/// A result that the scene does not request.
class NotWanted : public text::InputError {
 public:
  using InputError::InputError;
};

/// Registers the translation of these errors, and of the library's, to Python exceptions.
void translate_errors();

/// The same error with the scene's file in front.
[[nodiscard]] mechanism::OverConstrained in_file(const std::string& file,
                                                 const mechanism::OverConstrained& error);

/// Returns the result of `use`. An error of the mechanism that it throws gets the scene's file in
/// front, as in the command.
template <typename Use>
auto in_scene(const std::string& file, const Use& use) {
  try {
    return use();
  } catch (const mechanism::OverConstrained& error) {
    throw in_file(file, error);
  } catch (const mechanism::MechanismError& error) {
    throw mechanism::MechanismError(file, error.what());
  }
}

}  // namespace assur::python
