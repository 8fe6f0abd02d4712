// Loop closures as sums of lengths times directions, each with the frame of its closing link.
#pragma once

#include <string>
#include <vector>

#include "equations/closure.hpp"

namespace assur::generator::pivoting {

/// One vector of a loop: length x R(quarter_turns * 90 deg) (cos angle, sin angle).
struct PolarTerm {
  const equations::Variable* length;
  equations::AngleSum angle;
  int quarter_turns;  ///< 0 .. 3; two of them are a minus sign
};

/// A loop closure, sum of terms = 0, and the frame in which it is projected: the direction of a
/// vector whose unknown occurs in no other loop, so that one of the two projections is free of it.
struct PolarLoop {
  std::vector<PolarTerm> terms;
  equations::AngleSum frame;
  std::string frame_name;  ///< `CD` for the link that turns by theta_CD, `slide_C` for a slide
};

/// The loops of a model in polar form. Throws GeneratorError if a closure is not linear in lengths
/// with unit directions as coefficients.
[[nodiscard]] std::vector<PolarLoop> polar_loops(const equations::ClosureEquations& equations);

}  // namespace assur::generator::pivoting
