// The error of the generator for failures of its own derivations.
#pragma once

#include <stdexcept>
#include <string>

namespace assur::generator {

/// A case that the derivation does not cover: a defect of the generator, not bad input.
class GeneratorError : public std::logic_error {
 public:
  GeneratorError(const std::string& stage, const std::string& model, const std::string& what)
      : std::logic_error(stage + ", " + model + ": " + what) {}
};

}  // namespace assur::generator
