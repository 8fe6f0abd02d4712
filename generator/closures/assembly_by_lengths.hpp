// Assembles the closures at a random rational point by changing lengths.
#pragma once

#include "closures/circle_algebra.hpp"

namespace assur::generator::closures {

/// Solves the equations for as many lengths as there are equations. The lengths occur linearly and
/// independently; those with constant coefficients, such as coordinates, are preferred.
class AssemblyByLengths {
 public:
  AssemblyByLengths(std::vector<GiNaC::ex> equations, const GiNaC::lst& lengths);

  /// Returns false, with the values unchanged, if there are too few such lengths. Throws
  /// NotAlgebraic as CircleAlgebra::at does.
  [[nodiscard]] bool assemble(const CircleAlgebra& algebra, GiNaC::exmap& values) const;

 private:
  using Column = std::vector<GiNaC::ex>;  ///< derivatives of the equations with respect to a length

  std::vector<GiNaC::ex> equations_;
  std::vector<std::pair<GiNaC::ex, Column>> lengths_;  ///< those with constant columns first
};

}  // namespace assur::generator::closures
