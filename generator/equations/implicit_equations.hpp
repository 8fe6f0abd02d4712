// Implicit equations f(q, d, u) = 0 of a group or of any closures, in named variables.
#pragma once

#include <deque>
#include <vector>

#include "equations/variable.hpp"
#include "equations/vocabulary.hpp"

namespace assur::generator::equations {

/// Scalar equations f(q, d, u) = 0 with unknowns q, constant dimensions d, and inputs u, which may
/// move. Non-copyable, because angle sums and derivations point to the variables.
struct ImplicitEquations {
  ImplicitEquations() = default;
  ImplicitEquations(const ImplicitEquations&) = delete;
  ImplicitEquations& operator=(const ImplicitEquations&) = delete;
  ImplicitEquations(ImplicitEquations&&) = default;
  ImplicitEquations& operator=(ImplicitEquations&&) = default;
  ~ImplicitEquations() = default;

  std::deque<Variable> unknowns;
  std::deque<Variable> dimensions;
  std::deque<Variable> inputs;
  std::vector<GiNaC::ex> residuals;  ///< in the names of the vocabulary
  std::string residuals_meaning;     ///< one descriptive phrase
  Vocabulary vocabulary;
};

}  // namespace assur::generator::equations
