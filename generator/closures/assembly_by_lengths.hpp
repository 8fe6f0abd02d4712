// Turns a random rational point into one where the closures hold, by giving lengths other values.
#pragma once

#include "closures/circle_algebra.hpp"

namespace assur::generator::closures {

/// Gives as many of the lengths as there are equations the values that make the equations zero.
/// Taken are lengths that occur linearly and independently, those with constant coefficients (such
/// as coordinates) first. False, with the values unchanged, if there are too few. Throws
/// NotAlgebraic as CircleAlgebra::at does.
[[nodiscard]] bool assemble_by_lengths(const std::vector<GiNaC::ex>& equations,
                                       const GiNaC::lst& lengths, const CircleAlgebra& algebra,
                                       GiNaC::exmap& values);

}  // namespace assur::generator::closures
