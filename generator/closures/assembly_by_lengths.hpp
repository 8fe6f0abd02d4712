// Turns a random rational point into one where the closures hold, by giving lengths other values.
#pragma once

#include "closures/circle_algebra.hpp"

namespace assur::generator::closures {

/// Solves the equations for as many lengths as there are equations. It chooses lengths that occur
/// linearly and independently, and among these first the ones with constant coefficients, such as
/// coordinates.
class AssemblyByLengths {
 public:
  AssemblyByLengths(std::vector<GiNaC::ex> equations, const GiNaC::lst& lengths);

  /// Returns false, with the values unchanged, if there are too few such lengths. Throws
  /// NotAlgebraic as CircleAlgebra::at does.
  [[nodiscard]] bool assemble(const CircleAlgebra& algebra, GiNaC::exmap& values) const;

 private:
  using Column = std::vector<GiNaC::ex>;  ///< the derivatives of the equations by one length

  std::vector<GiNaC::ex> equations_;
  std::vector<std::pair<GiNaC::ex, Column>> lengths_;  ///< those with constant columns first
};

}  // namespace assur::generator::closures
