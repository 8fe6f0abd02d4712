// Start of a parameter continuation: a group with numbers whose complex configurations are all
// known.
#pragma once

#include <complex>

namespace assur::loops {

/// Loop closures of a group in general position with all their configurations, from which those of
/// the same group with other numbers are continued. Tables are column-major.
struct Start {
  int configurations;
  const std::complex<double>* of_angles;  ///< the coefficients, as in `LoopEquations`
  const std::complex<double>* of_slides;
  const std::complex<double>*
      theta;                      ///< one column of directions per configuration, the base's first
  const std::complex<double>* s;  ///< one column of displacements per configuration
  std::complex<double> turn;      ///< a number of modulus one that determines the paths
};

}  // namespace assur::loops
