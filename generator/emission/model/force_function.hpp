// Turns the equilibrium of a model's links into the function that finds the forces in its joints.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "emission/model/solution_functions.hpp"
#include "forces/group_forces.hpp"

namespace assur::generator::emission::model {

/// A function, and the symbols of loads, other forces and reciprocals that it is given, each with
/// the entry of a parameter that it is.
struct ForceFunction {
  NamingFunction naming;
  std::vector<std::pair<GiNaC::symbol, std::string>> given;

  /// Lets the function take reciprocals that `tell_reciprocals` makes another one tell.
  void take_reciprocals(const std::vector<GiNaC::symbol>& reciprocals);

  /// The order of all symbols that the function has.
  [[nodiscard]] program::SymbolOrder order(
      const equations::ClosureEquations& equations,
      const std::vector<equations::NamedQuantity>& known) const;
};

/// Lets a function of rates tell reciprocals that it divides by, too.
void tell_reciprocals(const std::vector<GiNaC::symbol>& reciprocals, ModelFunction& function);

/// The forces in all joints.
[[nodiscard]] ForceFunction force_function(const forces::GroupForces& forces);
/// What the loads do along the unknowns, from which the forces in the cut joints are found in
/// numbers.
[[nodiscard]] ForceFunction load_function(const forces::GroupForces& forces);

}  // namespace assur::generator::emission::model
