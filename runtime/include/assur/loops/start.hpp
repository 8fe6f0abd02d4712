// A group with other numbers whose complex configurations are all known.
#pragma once

#include <complex>

namespace assur::loops {

/// Loop closures of a group in general position with all of their configurations: those of the same
/// group with other numbers are continued from them. Tables stand column by column.
struct Start {
  int configurations;
  const std::complex<double>* of_angles;  ///< the coefficients, as `LoopEquations` has them
  const std::complex<double>* of_slides;
  const std::complex<double>* theta;  ///< a column of directions each, the base's first
  const std::complex<double>* s;      ///< a column of displacements each
  std::complex<double> turn;          ///< of modulus one: the paths depend on it
};

}  // namespace assur::loops
