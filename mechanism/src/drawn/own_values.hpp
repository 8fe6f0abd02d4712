// Turns formulas into numbers, by the values that a mechanism's parameters have in its description.
#pragma once

#include <assur/mechanism/mechanism.hpp>

#include "drawn/planar_formula.hpp"

namespace assur::mechanism::drawn {

/// The values of a mechanism's parameters.
class OwnValues {
 public:
  /// Throws MechanismError for a parameter that has no value or that depends on itself.
  explicit OwnValues(const Mechanism& mechanism);

  /// Throws MechanismError for a value that is not a finite number.
  [[nodiscard]] double of(const Formula& formula, const std::string& part) const;

 private:
  Table<ParameterIndex, double> parameters_;
};

}  // namespace assur::mechanism::drawn
