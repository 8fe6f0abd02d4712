// The implicit equations of a closure system: polynomials in named quantities.
#pragma once

#include <string>
#include <vector>

#include "closures/circle_algebra.hpp"
#include "closures/closure_system.hpp"
#include "equations/implicit_equations.hpp"

namespace assur::generator::closures {

/// The closures as f(q, d, u) = 0: unknowns q, dimensions d (parameters without rates) and inputs u
/// (moving parameters). Sines and cosines become components of directions; abbreviations, roots and
/// divisors become named quantities, roots and divisors with the degeneracy at which they fail. The
/// emitted code reserves the names of `types` everywhere, and `locals` in functions. Throws
/// NotAlgebraic with the closure's name if it is not a polynomial in such quantities.
[[nodiscard]] equations::ImplicitEquations implicit_form(const ClosureSystem& system,
                                                         const std::vector<std::string>& types,
                                                         const std::vector<std::string>& locals);

}  // namespace assur::generator::closures
