// Turns a failure of the generator into one typed error that names the stage and the model.
#pragma once

#include <stdexcept>
#include <string>

namespace assur::generator {

/// The generator met something that its derivation does not cover: a defect, not bad input.
class GeneratorError : public std::logic_error {
 public:
  GeneratorError(const std::string& stage, const std::string& model, const std::string& what)
      : std::logic_error(stage + ", " + model + ": " + what) {}
};

}  // namespace assur::generator
