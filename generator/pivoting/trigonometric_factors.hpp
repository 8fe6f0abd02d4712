// Turns a polynomial in cosines and sines alone into a product of cosines and sines of sums.
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

/// Writes an expression in cosines and sines of the equations' angles as a product; nothing if it
/// contains a length, or is no such product. With w = exp(2 i angle) for each angle, the expression
/// is a polynomial over the rationals, up to a power of i and a monomial, and a factor of two terms
/// is a cosine or a sine.
[[nodiscard]] std::optional<TrigonometricProduct> trigonometric_product(
    const GiNaC::ex& expression, const equations::ClosureEquations& equations);

}  // namespace assur::generator::pivoting
