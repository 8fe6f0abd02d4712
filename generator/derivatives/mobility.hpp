// Turns a model's equations into its verdict: the exact generic rank of the Jacobian decides.
#pragma once

#include <string>
#include <vector>

#include "derivatives/differentiate.hpp"

namespace assur::generator::derivatives {

/// Whether a group is a structure once its external joints are held.
struct Mobility {
  unsigned unknowns;
  unsigned rank;     ///< generic rank of the Jacobian where the group is assembled
  unsigned freedom;  ///< unknowns - rank: the mobility when it can be assembled
  bool rigid;        ///< square, of full rank, and with angles that nothing over-determines
  std::string reason;
};

/// Evaluates the Jacobian in rational numbers at random assembled configurations: the angles are
/// random rational points of the circle, and the lengths solve the equations, which are linear in
/// them. The rank at a point is never above the generic rank, so the largest of three is taken.
[[nodiscard]] Mobility mobility_of(const equations::ClosureEquations& equations,
                                   const ExpressionMatrix& jacobian);

/// An assembled configuration in rational numbers: a value for every symbol of the variables.
[[nodiscard]] GiNaC::exmap random_assembly(const equations::ClosureEquations& equations,
                                           unsigned seed);

}  // namespace assur::generator::derivatives
