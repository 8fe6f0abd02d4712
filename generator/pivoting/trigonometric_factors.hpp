// Factors a polynomial in cosines and sines into cosines and sines of sums of angles.
#pragma once

#include <optional>
#include <vector>

#include "equations/closure.hpp"

namespace assur::generator::pivoting {

/// cos(angle) or sin(angle).
struct TrigonometricFactor {
  bool sine;
  equations::AngleSum angle;
};

/// expression = sign * product of the factors.
struct TrigonometricProduct {
  int sign;
  std::vector<TrigonometricFactor> factors;
};

/// Factors an expression in cosines and sines of the equations' angles; empty if it contains a
/// length, or is not such a product. With w = exp(2 i angle) for each angle, the expression is a
/// polynomial over the rationals, up to a power of i and a monomial, and a factor of two terms is a
/// cosine or a sine.
[[nodiscard]] std::optional<TrigonometricProduct> trigonometric_product(
    const GiNaC::ex& expression, const equations::ClosureEquations& equations);

}  // namespace assur::generator::pivoting
