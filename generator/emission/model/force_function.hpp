// The emitted function that finds the joint forces of a model from the equilibrium of its links.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "emission/model/solution_functions.hpp"
#include "forces/group_forces.hpp"

namespace assur::generator::emission::model {

/// A function, and the symbols of its loads, other forces and reciprocals, each with the entry of
/// the parameter that holds it.
struct ForceFunction {
  NamingFunction naming;
  std::vector<std::pair<GiNaC::symbol, program::Place>> given;

  /// Makes parameters of the reciprocals that another function returns by `tell_reciprocals`.
  void take_reciprocals(const std::vector<GiNaC::symbol>& reciprocals);

  /// The order of all symbols in the function.
  [[nodiscard]] program::SymbolOrder order(
      const equations::ClosureEquations& equations,
      const std::vector<equations::NamedQuantity>& known) const;
};

/// Lets a function of rates also return the reciprocals by which it divides.
void tell_reciprocals(const std::vector<GiNaC::symbol>& reciprocals, ModelFunction& function);

/// The forces in all joints.
[[nodiscard]] ForceFunction force_function(const forces::GroupForces& forces);
/// The generalised loads along the unknowns, from which the runtime finds the forces in the cut
/// joints numerically.
[[nodiscard]] ForceFunction load_function(const forces::GroupForces& forces);

}  // namespace assur::generator::emission::model
