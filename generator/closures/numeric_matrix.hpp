// Inverse and determinant sign of a square matrix of values at a point.
#pragma once

#include <ginac/ginac.h>

namespace assur::generator::closures {

/// The inverse with the largest pivots. GiNaC takes the first nonzero pivot and loses all digits of
/// decimals if that one should be zero. Throws runtime_error if the matrix is singular.
[[nodiscard]] GiNaC::matrix inverse_of(const GiNaC::matrix& matrix);
/// The sign of the determinant; 0 if the matrix is singular. Roots of numbers count as decimals.
[[nodiscard]] int determinant_sign(const GiNaC::matrix& matrix);

}  // namespace assur::generator::closures
