// Eliminates unknowns from the reduced equations by a Bezout determinant: the final polynomial.
#pragma once

#include <optional>
#include <vector>

#include "elimination/reduction.hpp"
#include "elimination/univariate.hpp"

namespace assur::generator::elimination {

/// The closed form of a rigid model's position analysis.
struct Elimination {
  Reduction reduction;
  const equations::Variable* first;  ///< the unknown of the final polynomial
  const equations::Variable*
      second;  ///< the unknown eliminated by the determinant; null if there is none
  /// Each reduced equation as a polynomial in the second unknown: for an angle z the coefficients
  /// of cos z, sin z and 1; for a displacement those of z^2, z and 1. Empty without a second.
  std::vector<std::array<GiNaC::ex, 3>> in_second;
  /// The final polynomial: for an angle x the coefficients of (cos kx, sin kx), k = 0 .. degree;
  /// for a displacement those of x^k, with a zero second part.
  std::vector<equations::Vector2> polynomial;
  std::size_t degree;
  /// Whether the final polynomial is solved by formula.
  [[nodiscard]] bool is_closed() const {
    return degree == 1 || (degree == 2 && !first->is_angle());
  }
  std::size_t max_configurations;  ///< generic number of complex solutions
  equations::Vocabulary vocabulary;
  std::vector<RecordedStep> record;  ///< every step from the closures to the polynomial
  std::string polynomial_text;       ///< the polynomial in the names of `record`
};

/// The elimination of a rigid model. Takes the first choice of the final unknown with the lowest
/// generic degree.
[[nodiscard]] Elimination eliminate(const equations::ClosureEquations& equations);

}  // namespace assur::generator::elimination
