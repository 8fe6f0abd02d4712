// Mobility of a model by the exact generic rank of its Jacobian.
#pragma once

#include <string>
#include <vector>

#include "derivatives/differentiate.hpp"

namespace assur::generator::derivatives {

/// The mobility of a group with its external joints held.
struct Mobility {
  unsigned unknowns;
  unsigned rank;     ///< generic rank of the Jacobian in assembled configurations
  unsigned freedom;  ///< unknowns - rank: the mobility where it can be assembled
  bool rigid;        ///< square, of full rank, and no angle is over-determined
  std::string reason;
};

/// Evaluates the Jacobian in rational numbers at random assembled configurations: the angles are
/// random rational points of the circle, and the lengths solve the equations, which are linear in
/// them. The rank at a point never exceeds the generic rank, so the largest of three is taken.
[[nodiscard]] Mobility mobility_of(const equations::ClosureEquations& equations,
                                   const ExpressionMatrix& jacobian);

/// An assembled configuration in rational numbers: a value for every symbol of the variables.
[[nodiscard]] GiNaC::exmap random_assembly(const equations::ClosureEquations& equations,
                                           unsigned seed);

}  // namespace assur::generator::derivatives
