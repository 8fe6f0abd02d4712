// Reduces loop closures, by projecting and squaring, to one or two scalar equations, with formulas
// for the eliminated unknowns.
#pragma once

#include <vector>

#include "elimination/record.hpp"
#include "equations/closure.hpp"

namespace assur::generator::elimination {

/// The formula of an unknown in the remaining unknowns: numerators, each over the denominator,
/// whose zeros are degeneracies of the group.
struct BackSubstitution {
  const equations::Variable* unknown;
  std::vector<GiNaC::ex> numerators;  ///< a displacement's value; an angle's cosine and sine
  GiNaC::ex denominator;              ///< one, or an expression that must not vanish
  std::string degeneracy;             ///< the meaning of a zero denominator
};

/// The reduced system. All expressions are polynomials in variables, with the last external joint
/// as the origin: closure is translation-invariant, and far from the origin this loses no digits.
struct Reduction {
  std::vector<GiNaC::ex> equations;                   ///< as many as `remaining`
  std::vector<const equations::Variable*> remaining;  ///< angles first
  std::vector<BackSubstitution> steps;
  std::vector<RecordedStep> record;  ///< the derivation of the equations
};

/// `vocabulary` receives the names of the reduced quantities, such as `EB_x`.
[[nodiscard]] Reduction reduce(const equations::ClosureEquations& equations,
                               equations::Vocabulary& vocabulary);

/// Replaces cos^2 by 1 - sin^2 for every angle of the equations, and expands.
[[nodiscard]] GiNaC::ex on_circle(const GiNaC::ex& expression,
                                  const equations::ClosureEquations& equations);

}  // namespace assur::generator::elimination
