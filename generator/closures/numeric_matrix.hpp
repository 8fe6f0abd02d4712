// Turns a square matrix of values at a point into its inverse and the sign of its determinant.
#pragma once

#include <ginac/ginac.h>

namespace assur::generator::closures {

/// The inverse. GiNaC takes the first pivot that is not zero, which loses all digits of decimals
/// where that one should have been zero; here it is the largest. Throws runtime_error if the matrix
/// is singular.
[[nodiscard]] GiNaC::matrix inverse_of(const GiNaC::matrix& matrix);
/// The sign of the determinant; 0 if the matrix is singular. Roots of numbers count as decimals.
[[nodiscard]] int determinant_sign(const GiNaC::matrix& matrix);

}  // namespace assur::generator::closures
