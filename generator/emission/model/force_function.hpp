// Turns the equilibrium of a model's links into the function that finds the forces in its joints.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "emission/model/solution_functions.hpp"
#include "forces/group_forces.hpp"

namespace assur::generator::emission::model {

/// The function, and the symbols of the loads with the entry of a parameter that each one is.
struct ForceFunction {
  NamingFunction naming;
  std::vector<std::pair<GiNaC::symbol, std::string>> loads;

  /// The order of all symbols that the function has.
  [[nodiscard]] program::SymbolOrder order(
      const equations::ClosureEquations& equations,
      const std::vector<equations::NamedQuantity>& known) const;
};

[[nodiscard]] ForceFunction force_function(const forces::GroupForces& forces);

}  // namespace assur::generator::emission::model
